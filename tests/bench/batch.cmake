# treeline_batch_bench: states a second of batch functions, as wide as this machine's registers.
# Functions: those that the benchmark calls; scenes: those of the other benchmarks, for a batch.
function(bench_generate_batch name robot real states)
  set(urdf ${PROJECT_SOURCE_DIR}/tests/data/golden/${robot}.urdf)
  set(scene ${CMAKE_CURRENT_SOURCE_DIR}/scenes/${robot}.yaml)
  set(batch_scene ${CMAKE_CURRENT_BINARY_DIR}/${name}.yaml)
  bench_write_scene(${scene} "inverse_dynamics;control_torque" ${states} ${batch_scene})
  treeline_generate(${name} URDF ${urdf} SCENE ${batch_scene} REAL ${real})
  target_compile_options(${name} PRIVATE -O3 -march=native)
endfunction()

bench_generate_batch(bench_puma560 puma560 double 8)
bench_generate_batch(bench_humanoid24 humanoid24 double 8)
bench_generate_batch(bench_humanoid24f humanoid24 float 16)
add_executable(treeline_batch_bench batch_bench.cpp)
target_link_libraries(treeline_batch_bench PRIVATE bench_puma560 bench_humanoid24 bench_humanoid24f
  treeline_batch treeline_warnings benchmark::benchmark_main)
