# chains_of_headers(ROOT HEADERS RESULT): divides headers into chains, each header of which includes, directly or not, the one
# before it. RESULT: a list of chains, the headers of each separated by `|`.
#
# A translation unit that includes a chain in this order shows of each of its headers that it compiles alone: what is
# visible at its begin is only what it includes itself. So that is shown with as many units as there are chains (78 for 223
# headers) instead of one for each header.

# The headers of the list that a header includes, directly or not; cycles are allowed. RESULT_use_eigen: whether one of these or
# the header itself includes Eigen.
function(included_headers root headers header result)
  set(use_eigen FALSE)
  set(found)
  set(open ${header})
  while(open)
    list(POP_FRONT open next)
    file(STRINGS ${root}/${next} lines REGEX "^#include <")
    list(TRANSFORM lines REPLACE "^#include <(.*)>.*" "\\1")
    if(lines MATCHES "(^|;)Eigen/")
      set(use_eigen TRUE)
    endif()
    foreach(included IN LISTS lines)
      if(included IN_LIST headers AND NOT included IN_LIST found)
        list(APPEND found ${included})
        list(APPEND open ${included})
      endif()
    endforeach()
  endwhile()
  list(REMOVE_ITEM found ${header})
  set(${result} ${found} PARENT_SCOPE)
  set(${result}_use_eigen ${use_eigen} PARENT_SCOPE)
endfunction()

function(chains_of_headers root headers result)
  # The headers in decreasing order of the number that they include, those with Eigen first: its solvers take 10 s wherever they
  # are instantiated, so what uses them is in few chains.
  set(order)
  foreach(header IN LISTS headers)
    included_headers(${root} "${headers}" ${header} included_by_${header})
    list(LENGTH included_by_${header} number)
    math(EXPR rank "10000 + ${number}")
    if(included_by_${header}_use_eigen)
      math(EXPR rank "${rank} + 1000")
    endif()
    list(APPEND order "${rank} ${header}")
  endforeach()
  list(SORT order ORDER DESCENDING)
  list(TRANSFORM order REPLACE "^[0-9]+ " "")

  set(chains)
  while(order)
    list(POP_FRONT order last)
    set(chain ${last})
    foreach(header IN LISTS order)
      if(header IN_LIST included_by_${last})
        string(PREPEND chain "${header}|")
        set(last ${header})
      endif()
    endforeach()
    string(REPLACE "|" ";" members "${chain}")
    list(REMOVE_ITEM order ${members})
    list(APPEND chains "${chain}")
  endwhile()
  set(${result} ${chains} PARENT_SCOPE)
endfunction()
