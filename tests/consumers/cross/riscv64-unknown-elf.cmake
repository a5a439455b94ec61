set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_C_FLAGS_INIT -ffreestanding)  # there is no library
set(CMAKE_CXX_FLAGS_INIT -ffreestanding)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
