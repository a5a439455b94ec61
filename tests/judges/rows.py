"""Rows of frames: of tasks, of supports, of loops between two links and of couplings. Their Jacobians and Jd qd."""

import numpy as np

ALL_ROWS = ("x", "y", "z", "rx", "ry", "rz")


def place_yaml(xyz, rpy):
    numbers = lambda values: "[" + ", ".join(repr(float(x)) for x in values) + "]"
    return f"{{xyz: {numbers(xyz)}, rpy: {numbers(rpy)}}}"


class Point:
    """A frame on a link, and which of its rows count."""

    def __init__(self, name, link, xyz, rpy, axes, rows=ALL_ROWS):
        self.name, self.link, self.xyz, self.rpy, self.axes, self.rows = name, link, xyz, rpy, axes, tuple(rows)

    @property
    def indices(self):
        return [ALL_ROWS.index(row) for row in self.rows]

    def yaml(self, with_rows=True):
        rows = f", rows: [{', '.join(self.rows)}]" if with_rows else ""
        return (f'{{name: {self.name}, link: "{self.link}", origin: {place_yaml(self.xyz, self.rpy)}, '
                f"axes: {self.axes}{rows}}}")


    def pose(self, figures):
        return figures.pose(self.name)

    def jacobian(self, figures):
        return figures.jacobian(self.name)

    def bias(self, figures):
        return figures.acceleration(self.name, False)


class Center(Point):
    """The centre of mass, in the world's axes, which do not turn."""

    def __init__(self, name):
        super().__init__(name, None, None, None, "world", ALL_ROWS[:3])

    def yaml(self, with_rows=True):
        return f"{{name: {self.name}, center_of_mass: true, rows: [{', '.join(self.rows)}]}}"

    def pose(self, figures):
        return np.eye(3), figures.center_of_mass()

    def jacobian(self, figures):
        J = figures.center_of_mass_jacobian()
        return np.vstack([J, np.zeros_like(J)])

    def bias(self, figures):
        return np.concatenate([figures.center_of_mass_bias(), np.zeros(3)])


def rows_jacobian(figures, points):
    """The velocities of the rows are J qd: their axes turn with the link where they are local."""
    blocks = []
    for point in points:
        J = point.jacobian(figures)
        if point.axes == "local":
            R = figures.pose(point.name)[0]
            J = np.vstack([R.T @ J[:3], R.T @ J[3:]])
        blocks.append(J[point.indices])
    return np.vstack(blocks) if blocks else np.zeros((0, figures.T.shape[1]))


def rows_bias(figures, points):
    """Jd qd, the derivative of the rows' velocities at qdd = 0: R^T a - w x v in local axes."""
    blocks = []
    for point in points:
        a = point.bias(figures)
        if point.axes == "local":
            R, twist = figures.pose(point.name)[0], figures.velocity(point.name)
            v, w = R.T @ twist[:3], R.T @ twist[3:]
            a = np.concatenate([R.T @ a[:3] - np.cross(w, v), R.T @ a[3:]])
        blocks.append(a[point.indices])
    return np.concatenate(blocks) if blocks else np.zeros(0)


class Loop:
    """Rows of the first frame's velocity against the second's, in the second's axes."""

    def __init__(self, first, second, rows):
        self.first, self.second, self.rows = first, second, tuple(rows)

    @property
    def indices(self):
        return [ALL_ROWS.index(row) for row in self.rows]

    def jacobian(self, figures):
        J1, J2, R, d = self._relative_frames(figures)
        linear = J1[:3] - J2[:3] + skew(d) @ J2[3:]  # v1 - v2 - w2 x d
        return np.vstack([R.T @ linear, R.T @ (J1[3:] - J2[3:])])[self.indices]

    def bias(self, figures):
        """The derivative of R^T (v1 - v2 - w2 x d) and R^T (w1 - w2) at qdd = 0: R turns with w2."""
        R, d = self._relative_frames(figures)[2:]
        (v1, w1), (v2, w2) = (np.split(figures.velocity(frame), 2) for frame in (self.first, self.second))
        (a1, b1), (a2, b2) = (np.split(figures.acceleration(frame, False), 2) for frame in (self.first, self.second))
        slip = v1 - v2 - np.cross(w2, d)
        linear = a1 - a2 - np.cross(b2, d) - np.cross(w2, v1 - v2) - np.cross(w2, slip)
        return np.concatenate([R.T @ linear, R.T @ (b1 - b2 - np.cross(w2, w1 - w2))])[self.indices]

    def errors(self, figures):
        """Displacements and sines of turns, in the second frame's axes."""
        (R1, p1), (R2, p2) = figures.pose(self.first), figures.pose(self.second)
        turn = R2.T @ R1
        sines = 0.5 * np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
        return np.concatenate([R2.T @ (p1 - p2), sines])[self.indices]

    def _relative_frames(self, figures):
        p1, (R, p2) = figures.pose(self.first)[1], figures.pose(self.second)
        return figures.jacobian(self.first), figures.jacobian(self.second), R, p1 - p2


class Rolling:
    """A ball, or a thin disc about an axis of its frame, on a plane of the world that it touches."""

    rows, indices = ("x", "y", "z"), [0, 1, 2]

    def __init__(self, frame, radius, axis):
        self.frame, self.radius, self.axis = frame, radius, axis
        self.plane = None

    def touch(self, figures, tilt):
        """Puts the plane, turned by `tilt`, under it where it is."""
        n = tilt[:, 2]
        R, center = figures.pose(self.frame)
        steep = 1.0 if self.axis is None else np.sqrt(1 - (n @ R @ self.axis) ** 2)
        self.plane = tilt, center - self.radius * steep * n

    def _arm(self, height, axis):
        """From the centre to what touches: down, or of a disc down its face as far as the plane."""
        n = self.plane[0][:, 2]
        if axis is None:
            return -self.radius * n + 0 * height
        return -height * (n - (n @ axis) * axis) / (1 - (n @ axis) ** 2)

    def _height_and_axis(self, figures):
        R, center = figures.pose(self.frame)
        return self.plane[0][:, 2] @ (center - self.plane[1]), None if self.axis is None else R @ self.axis

    def jacobian(self, figures):
        J = figures.jacobian(self.frame)
        return self.plane[0].T @ (J[:3] - skew(self._arm(*self._height_and_axis(figures))) @ J[3:])

    def bias(self, figures):
        """The derivative of v + w x r at qdd = 0. The arm r runs along the rim: a complex step differentiates it."""
        (v, w), (a, b) = np.split(figures.velocity(self.frame), 2), np.split(figures.acceleration(self.frame, False), 2)
        height, axis = self._height_and_axis(figures)
        rise, step = self.plane[0][:, 2] @ v, 1e-30j
        moved = self._arm(height + step * rise, None if axis is None else axis + step * np.cross(w, axis))
        return self.plane[0].T @ (a + np.cross(b, self._arm(height, axis)) + np.cross(w, moved.imag / step.imag))

    def errors(self, figures):
        """It touches wherever it is asked."""
        return np.zeros(3)


def row_shares(points, shares):
    """To which share each row of points that come and go is held or done."""
    counts = [len(point.rows) for point in points]
    return np.ones(sum(counts)) if shares is None else np.repeat(shares, counts)


def held_shares(case, shares):
    """Likewise of all held rows: loops and couplings stay."""
    others = sum(len(loop.rows) for loop in case.loops) + len(case.couplings)
    return np.concatenate([row_shares(case.held, shares), np.ones(others)])


def skew(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def held_jacobian(figures, case):
    """Of supports, then loops, then couplings."""
    return np.vstack([rows_jacobian(figures, case.held), *(loop.jacobian(figures) for loop in case.loops),
                      *case.coupling_rows()])


def held_bias(figures, case):
    return np.concatenate([rows_bias(figures, case.held), *(loop.bias(figures) for loop in case.loops),
                           np.zeros(len(case.couplings))])


def constraint_errors(figures, case, q):
    """Of loops, then sums of couplings."""
    return np.concatenate([np.zeros(0), *(loop.errors(figures) for loop in case.loops),
                           *(row @ q for row in case.coupling_rows())])  # of joints with one coordinate
