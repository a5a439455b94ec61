# Gives the scene of a PUMA's controller in FILE behaviours that do the tool's task, or leave it.
# cmake -DFILE=scene.yaml -P add_behaviours.cmake
file(READ ${FILE} scene)
string(REPLACE "controller:\n" "controller:\n  behaviours: {do: [tool], leave: []}\n" scene "${scene}")
file(WRITE ${FILE} "${scene}\ninputs: {active: [tool]}\n")
