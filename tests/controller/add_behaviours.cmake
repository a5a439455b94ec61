# Gives a scene of a PUMA's controller behaviours that do the tool's task, or leave it.
function(add_behaviours file)
  file(READ ${file} scene)
  string(REPLACE "controller:\n" "controller:\n  behaviours: {do: [tool], leave: []}\n" scene "${scene}")
  file(WRITE ${file} "${scene}\ninputs: {active: [tool]}\n")
endfunction()
