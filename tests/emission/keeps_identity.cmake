# Would catch: a binary that does not say what code is in it, though linked as the emitted project
# asks, a digest that nobody can make again, and double constants that a flag rounds to float.
# cmake -DNAME=robot -DCOMPILER=g++ -DENDING=cpp -DSTANDARD=-std=c++17 -DLIBRARY=libNAME.a
#   -DFOLDER=generated-folder -P keeps_identity.cmake
file(READ ${FOLDER}/CMakeLists.txt project)
if(NOT project MATCHES "INTERFACE \"LINKER:(--undefined=${NAME}_id)\"")
  message(FATAL_ERROR "the emitted project does not keep ${NAME}_id")
endif()
set(keep -Wl,${CMAKE_MATCH_1})
set(program ${FOLDER}_identity)
file(WRITE ${program}.${ENDING} "int main(void) { return 0; }\n")
execute_process(COMMAND ${COMPILER} ${STANDARD} ${program}.${ENDING} ${LIBRARY} ${keep} -Wl,--gc-sections
  -o ${program} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND sh -c
  "cd ${FOLDER} && sed -n '/\"outputs\"/,$ s/.*\"file\": \"\\([^\"]*\\)\".*/\\1/p' manifest.json |
    grep -v '^id\\.' | LC_ALL=C sort | xargs sha256sum | sha256sum"
  OUTPUT_VARIABLE digest COMMAND_ERROR_IS_FATAL ANY)
string(SUBSTRING "${digest}" 0 64 digest)
execute_process(COMMAND sh -c "grep -a -o 'treeline [0-9.]* ${NAME} sha256 ${digest}' ${program}"
  RESULT_VARIABLE missing)
if(missing)
  message(FATAL_ERROR "the program does not have ${NAME}_id with the digest ${digest}")
endif()

execute_process(COMMAND ${COMPILER} ${STANDARD} -fsingle-precision-constant -fsyntax-only
  ${FOLDER}/inverse_dynamics.${ENDING} RESULT_VARIABLE stopped ERROR_QUIET)
if(NOT stopped)
  message(FATAL_ERROR "-fsingle-precision-constant is taken in silence")
endif()
