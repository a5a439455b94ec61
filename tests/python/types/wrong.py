"""What mypy has to refuse: each line, by the code behind it."""

import treeline

treeline.load(3)  # arg-type
treeline.load("arm.urdf", ["scene.yaml"])  # arg-type
treeline.load("arm.urdf", real="half")  # arg-type
treeline.load("arm.urdf", None, ["gravity"])  # call-arg
treeline.check("arm.urdf", states="10")  # arg-type
treeline.draw("arm.urdf").png  # attr-defined
treeline.Diagnostic("error", "", 0, "", "", "", "").line = 3  # misc
