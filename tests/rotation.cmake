# What takes too long for every run of CI is run in turns: the set `ci` adds one share of what only the
# set `all` has. `./verify --ci` takes the share from the hash of the commit.
set(TREELINE_ROTATION "" CACHE STRING "K/N, counted from 0: the share of the long tests that the set ci adds")

if(TREELINE_ROTATION MATCHES "^([0-9]+)/([1-9][0-9]*)$" AND CMAKE_MATCH_1 LESS CMAKE_MATCH_2)
  set(rotation_share ${CMAKE_MATCH_1})
  set(rotation_shares ${CMAKE_MATCH_2})
elseif(NOT TREELINE_ROTATION STREQUAL "")
  message(FATAL_ERROR "TREELINE_ROTATION is `${TREELINE_ROTATION}`, and must be K/N with K below N, such as 0/8")
endif()

# place_is_due(PLACE VARIABLE): whether this build has what stands at this place of a list of long tests.
function(place_is_due place variable)
  set(due FALSE)
  if(TREELINE_TEST_SET STREQUAL all)
    set(due TRUE)
  elseif(TREELINE_TEST_SET STREQUAL ci AND DEFINED rotation_share)
    math(EXPR due_share "${place} % ${rotation_shares}")
    if(due_share EQUAL rotation_share)
      set(due TRUE)
    endif()
  endif()
  set(${variable} ${due} PARENT_SCOPE)
endfunction()

# name_is_due(NAME VARIABLE): the same by a name, for long tests that no list names.
function(name_is_due name variable)
  string(MD5 hash "${name}")
  string(SUBSTRING "${hash}" 0 6 hash)
  math(EXPR place "0x${hash}")
  place_is_due(${place} due)
  set(${variable} ${due} PARENT_SCOPE)
endfunction()

# The folders that only the set `all` has whole. A share of eight has one of them.
set(long_test_folders bench_variants compatibility experiments finite firmware reproducibility robots stress)
set(due_test_folders)
set(place 0)
foreach(folder IN LISTS long_test_folders)
  place_is_due(${place} due)
  if(due)
    list(APPEND due_test_folders ${folder})
  endif()
  math(EXPR place "${place} + 1")
endforeach()
if(DEFINED rotation_share)
  message(NOTICE "-- Long tests in turns, share ${TREELINE_ROTATION}: ${due_test_folders}")
endif()
