//! dynibo: inverse and forward dynamics, M and gravity. Its structures are those of `../peer.hpp`.
use dynibo::{BaseState, FloatingRobot, Frame, Robot, Twist};
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};
use std::collections::HashMap;
use std::ffi::{c_char, c_int, c_void, CStr, CString};
use std::slice::{from_raw_parts, from_raw_parts_mut};

const VERSION: c_int = 3;
const GRAVITY: f64 = 9.80665;

#[repr(C)]
pub struct PeerRobot {
    urdf: *const c_char,
    floating: bool,
    gravity: [f64; 3],
    velocities: c_int,
    links: *const *const c_char,
    // Points, constraints and names of functions follow, which nothing here needs.
}

type Say = extern "C" fn(*mut c_void, *const c_char);
type Call = unsafe extern "C" fn(*mut c_void, *const *const f64, *mut f64);

#[repr(C)]
pub struct Routine {
    function: *const c_char,
    route: *const c_char,
    solver: *mut c_void,
    call: Call,
    finish: Option<unsafe extern "C" fn(*mut c_void, *mut f64)>,
}

#[repr(C)]
pub struct Peer {
    version: c_int,
    name: *const c_char,
    release: *const c_char,
    open: unsafe extern "C" fn(*const PeerRobot, Say, *mut c_void) -> *mut c_void,
    list: unsafe extern "C" fn(*mut c_void, *mut *const Routine) -> c_int,
    close: unsafe extern "C" fn(*mut c_void),
    records: bool,
}

enum Any {
    Fixed(Robot),
    Floating(FloatingRobot),
}

/// A robot, the place of each of our joints among dynibo's, and memory for what a call reads.
struct Solver {
    robot: Any,
    places: Vec<usize>,
    q: Vec<f64>,
    qd: Vec<f64>,
    drive: Vec<f64>,
    out: Vec<f64>,
    rotation: UnitQuaternion<f64>,
}

struct Opened {
    _solver: Box<Solver>,
    routines: Vec<Routine>,
}

fn three(from: &[f64]) -> Vector3<f64> {
    Vector3::new(from[0], from[1], from[2])
}

impl Solver {
    fn base(&self) -> usize {
        if matches!(self.robot, Any::Floating(_)) { 6 } else { 0 }
    }
    fn size(&self) -> usize {
        self.base() + self.places.len()
    }

    /// The pose of the base, and its motion, whose linear part is along its own axes in our arguments and along the
    /// world's here.
    fn load_base(&mut self, q: &[f64], qd: Option<&[f64]>, qdd: Option<&[f64]>) -> BaseState {
        self.rotation = UnitQuaternion::from_quaternion(Quaternion::new(q[6], q[3], q[4], q[5]));
        let frame = Frame::from_parts(Translation3::new(q[0], q[1], q[2]), self.rotation);
        let rotation = self.rotation;
        let zero = Vector3::zeros();
        let (v, w) = qd.map_or((zero, zero), |qd| (three(qd), three(&qd[3..])));
        let acceleration = qdd.map_or(Twist::new(zero, zero), |qdd| {
            Twist::new(rotation * three(&qdd[3..]), rotation * (three(qdd) + w.cross(&v)))
        });
        BaseState::new(frame, Twist::new(rotation * w, rotation * v), acceleration).unwrap()
    }

    /// Copies joints, which stand in dynibo's order there.
    fn load(places: &[usize], from: &[f64], to: &mut [f64]) {
        for (i, place) in places.iter().enumerate() {
            to[*place] = from[i];
        }
    }

    /// dynibo has angular over linear of the base, both along the world's axes.
    fn store(&self, out: &mut [f64]) {
        let base = self.base();
        if base > 0 {
            let linear = self.rotation.inverse() * three(&self.out[3..]);
            let angular = self.rotation.inverse() * three(&self.out);
            out[..3].copy_from_slice(linear.as_slice());
            out[3..6].copy_from_slice(angular.as_slice());
        }
        for (i, place) in self.places.iter().enumerate() {
            out[base + i] = self.out[base + *place];
        }
    }
}

/// A call with its arguments; the coordinates of the joints are loaded.
struct Begun<'a> {
    solver: &'a mut Solver,
    given: Vec<&'a [f64]>,
    base: usize,
    out: &'a mut [f64],
}

/// Begins a call of so many inputs, whose result is a vector, or a square matrix.
unsafe fn begin<'a>(
    solver: *mut c_void, input: *const *const f64, out: *mut f64, inputs: usize, is_matrix: bool,
) -> Begun<'a> {
    let solver = &mut *(solver as *mut Solver);
    let (size, base) = (solver.size(), solver.base());
    let quaternion = usize::from(base > 0); // one number more than the base has velocities
    let read = |k: usize| from_raw_parts(*input.add(k), size + if k == 0 { quaternion } else { 0 });
    let given: Vec<&[f64]> = (0..inputs).map(read).collect();
    Solver::load(&solver.places, &given[0][base + quaternion..], &mut solver.q);
    let out = from_raw_parts_mut(out, if is_matrix { size * size } else { size });
    Begun { solver, given, base, out }
}

unsafe extern "C" fn inverse_dynamics(solver: *mut c_void, input: *const *const f64, out: *mut f64) {
    let Begun { solver: s, given, base, out } = begin(solver, input, out, 3, false);
    Solver::load(&s.places, &given[1][base..], &mut s.qd);
    Solver::load(&s.places, &given[2][base..], &mut s.drive);
    let state = (base > 0).then(|| s.load_base(given[0], Some(given[1]), Some(given[2])));
    match &mut s.robot {
        Any::Fixed(robot) => robot.inverse_dynamics(&s.q, &s.qd, &s.drive[..s.places.len()], &[], &mut s.out).unwrap(),
        Any::Floating(robot) => {
            robot.inverse_dynamics(&state.unwrap(), &s.q, &s.qd, &s.drive[..s.places.len()], &[], &mut s.out).unwrap()
        }
    }
    s.store(out);
}

unsafe extern "C" fn forward_dynamics(solver: *mut c_void, input: *const *const f64, out: *mut f64) {
    let Begun { solver: s, given, base, out } = begin(solver, input, out, 3, false);
    Solver::load(&s.places, &given[1][base..], &mut s.qd);
    let state = (base > 0).then(|| s.load_base(given[0], Some(given[1]), None));
    if base > 0 {
        let force = s.rotation * three(given[2]);
        let moment = s.rotation * three(&given[2][3..]);
        s.drive[..3].copy_from_slice(moment.as_slice());
        s.drive[3..6].copy_from_slice(force.as_slice());
    }
    Solver::load(&s.places, &given[2][base..], &mut s.drive[base..]);
    match &mut s.robot {
        Any::Fixed(robot) => robot.forward_dynamics(&s.q, &s.qd, &s.drive, &[], &mut s.out).unwrap(),
        Any::Floating(robot) => {
            robot.forward_dynamics(&state.unwrap(), &s.q, &s.qd, &s.drive, &[], &mut s.out).unwrap()
        }
    }
    s.store(out);
    if base > 0 {
        let turning = three(&given[1][3..]).cross(&three(given[1]));
        for k in 0..3 {
            out[k] -= turning[k];
        }
    }
}

unsafe extern "C" fn mass_matrix(solver: *mut c_void, input: *const *const f64, out: *mut f64) {
    let Begun { solver: s, given, base, out } = begin(solver, input, out, 1, true);
    let state = (base > 0).then(|| s.load_base(given[0], None, None));
    match &mut s.robot {
        Any::Fixed(robot) => robot.mass_matrix(&s.q, out).unwrap(),
        Any::Floating(robot) => robot.mass_matrix(&state.unwrap(), &s.q, out).unwrap(),
    }
}

/// Brings M into our order, row by row and column by column.
unsafe extern "C" fn finish_mass_matrix(solver: *mut c_void, out: *mut f64) {
    let s = &mut *(solver as *mut Solver);
    let n = s.size();
    let out = from_raw_parts_mut(out, n * n);
    for pass in 0..2 {
        let theirs = out.to_vec();
        let mut ours = vec![0.0; n];
        for i in 0..n {
            for k in 0..n {
                s.out[k] = if pass == 0 { theirs[i * n + k] } else { theirs[k * n + i] };
            }
            s.store(&mut ours);
            for k in 0..n {
                out[if pass == 0 { i * n + k } else { k * n + i }] = ours[k];
            }
        }
    }
}

unsafe extern "C" fn gravity(solver: *mut c_void, input: *const *const f64, out: *mut f64) {
    let Begun { solver: s, given, base, out } = begin(solver, input, out, 1, false);
    let state = (base > 0).then(|| s.load_base(given[0], None, None));
    match &mut s.robot {
        Any::Fixed(robot) => robot.gravity(&s.q, &[], &mut s.out).unwrap(),
        Any::Floating(robot) => robot.gravity(&state.unwrap(), &s.q, &[], &mut s.out).unwrap(),
    }
    s.store(out);
}

/// The place of each joint that moves one of `links` among the joints of a model.
fn find_places(urdf: &str, links: &[String], names: &[String]) -> Result<Vec<usize>, String> {
    let file = urdf_rs::read_file(urdf).map_err(|fault| fault.to_string())?;
    let joint_of: HashMap<_, _> = file.joints.iter().map(|j| (&j.child.link, &j.name)).collect();
    links
        .iter()
        .map(|link| {
            let joint = joint_of.get(link).ok_or(format!("has no joint for link {link}"))?;
            names.iter().position(|name| name == *joint).ok_or(format!("has no joint {joint}"))
        })
        .collect()
}

unsafe fn read(robot: &PeerRobot) -> Result<Solver, String> {
    if robot.gravity != [0.0, 0.0, -GRAVITY] {
        return Err(format!("has no other gravity than {GRAVITY} m/s^2 along -z"));
    }
    let text = |from: *const c_char| CStr::from_ptr(from).to_string_lossy().into_owned();
    let urdf = text(robot.urdf);
    let links: Vec<String> = from_raw_parts(robot.links, robot.velocities as usize)
        .iter()
        .map(|link| text(*link))
        .skip(if robot.floating { 6 } else { 0 })
        .collect();
    let fault = |fault: dynibo::Error| fault.to_string();
    let (made, names) = if robot.floating {
        let made = FloatingRobot::from_urdf(&urdf).map_err(fault)?;
        let names = (0..made.joint_count()).map(|i| made.joint_name(i).unwrap().into()).collect();
        (Any::Floating(made), names)
    } else {
        let made = Robot::from_urdf(&urdf).map_err(fault)?;
        let names = (0..made.joint_count()).map(|i| made.joint_name(i).unwrap().into()).collect();
        (Any::Fixed(made), names)
    };
    let names: Vec<String> = names;
    if names.len() != links.len() {
        return Err("counts other joints than the scene".into());
    }
    let places = find_places(&urdf, &links, &names)?;
    let n = places.len();
    let all = robot.velocities as usize;
    Ok(Solver {
        robot: made,
        places,
        q: vec![0.0; n],
        qd: vec![0.0; n],
        drive: vec![0.0; all],
        out: vec![0.0; all],
        rotation: UnitQuaternion::identity(),
    })
}

unsafe extern "C" fn open(robot: *const PeerRobot, say: Say, listener: *mut c_void) -> *mut c_void {
    let solver = match read(&*robot) {
        Ok(solver) => solver,
        Err(fault) => {
            let sentence = CString::new(fault).unwrap_or_default();
            say(listener, sentence.as_ptr());
            return std::ptr::null_mut();
        }
    };
    let mut kept = Box::new(solver);
    let at = &mut *kept as *mut Solver as *mut c_void;
    let row = |function: &'static CStr, call: Call, finish| Routine {
        function: function.as_ptr(),
        route: c"".as_ptr(),
        solver: at,
        call,
        finish,
    };
    let routines = vec![
        row(c"inverse_dynamics", inverse_dynamics, None),
        row(c"forward_dynamics", forward_dynamics, None),
        row(c"mass_matrix", mass_matrix, Some(finish_mass_matrix)),
        row(c"gravity", gravity, None),
    ];
    Box::into_raw(Box::new(Opened { _solver: kept, routines })) as *mut c_void
}

unsafe extern "C" fn list(opened: *mut c_void, routines: *mut *const Routine) -> c_int {
    let all = &(*(opened as *const Opened)).routines;
    *routines = all.as_ptr();
    all.len() as c_int
}

unsafe extern "C" fn close(opened: *mut c_void) {
    drop(Box::from_raw(opened as *mut Opened));
}

struct Shared(Peer);
unsafe impl Sync for Shared {}
static PEER: Shared = Shared(Peer {
    version: VERSION,
    name: c"dynibo".as_ptr(),
    release: c"0.5.3".as_ptr(),
    open,
    list,
    close,
    records: false,
});

#[no_mangle]
pub extern "C" fn treeline_peer() -> *const Peer {
    &PEER.0
}
