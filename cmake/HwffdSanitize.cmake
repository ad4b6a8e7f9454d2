# Second copies of libraries under AddressSanitizer and UndefinedBehaviorSanitizer, and with assertions
# (Eigen's check every index), for the tests of robustness; any finding ends the program. Casts of
# what no integer holds, such as NaN, are not among what `undefined` looks for.
#
# The checks of each pointer that is followed, which AddressSanitizer has for the most part too, take as long to
# compile as all else: they are for the tier `all`, as is the optimizer.

set(HWFFD_SANITIZE_OPTIONS
  -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer -g1 -UNDEBUG)
if(HWFFD_TIER STREQUAL all)
  list(APPEND HWFFD_SANITIZE_OPTIONS -O1)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    list(APPEND HWFFD_SANITIZE_OPTIONS -Wno-stringop-overflow)  # of fmt's buffers, which it loses sight of behind a check
  endif()
else()
  list(APPEND HWFFD_SANITIZE_OPTIONS -O0
    -fno-sanitize=null,alignment,vptr,object-size,return,nonnull-attribute,returns-nonnull-attribute)
endif()

# hwffd_sanitize(<library>...)
#
# Makes of each static library the library <library>_sanitized, of the same sources. Among the libraries
# that it links, those that have such a copy are replaced by it: list a library after those it links.
function(hwffd_sanitize)
  foreach(library IN LISTS ARGN)
    get_target_property(folder ${library} SOURCE_DIR)
    get_target_property(sources ${library} SOURCES)
    list(TRANSFORM sources PREPEND ${folder}/ REGEX "^[^/]")
    add_library(${library}_sanitized STATIC EXCLUDE_FROM_ALL ${sources})
    foreach(kind INCLUDE_DIRECTORIES INTERFACE_INCLUDE_DIRECTORIES COMPILE_OPTIONS
        INTERFACE_COMPILE_OPTIONS)
      get_target_property(words ${library} ${kind})
      if(words)
        set_property(TARGET ${library}_sanitized PROPERTY ${kind} ${words})
      endif()
    endforeach()
    hwffd_sanitized_links(links ${library} LINK_LIBRARIES)
    hwffd_sanitized_links(public_links ${library} INTERFACE_LINK_LIBRARIES)
    set_property(TARGET ${library}_sanitized PROPERTY LINK_LIBRARIES ${links})
    set_property(TARGET ${library}_sanitized PROPERTY INTERFACE_LINK_LIBRARIES ${public_links})
    target_compile_options(${library}_sanitized PUBLIC ${HWFFD_SANITIZE_OPTIONS})
    foreach(kind UNITY_BUILD UNITY_BUILD_BATCH_SIZE)
      get_target_property(word ${library} ${kind})
      set_property(TARGET ${library}_sanitized PROPERTY ${kind} ${word})
    endforeach()
    foreach(source IN LISTS sources)
      foreach(kind SKIP_UNITY_BUILD_INCLUSION LANGUAGE COMPILE_OPTIONS)
        get_source_file_property(word ${source} TARGET_DIRECTORY ${library} ${kind})
        if(word)
          set_source_files_properties(${source} PROPERTIES ${kind} ${word})
        endif()
      endforeach()
    endforeach()
    target_link_options(${library}_sanitized PUBLIC ${HWFFD_SANITIZE_OPTIONS})
  endforeach()
endfunction()

# The libraries in a property of a library, the copies in place of those that have one. What depends on the program is
# left out: the caller says which it is.
function(hwffd_sanitized_links result library property)
  get_target_property(links ${library} ${property})
  set(replaced "")
  foreach(link IN LISTS links)
    string(REGEX REPLACE "^[$]<LINK_ONLY:(.*)>$" "\\1" name "${link}")
    if(TARGET ${name}_sanitized)
      list(APPEND replaced ${name}_sanitized)
    elseif(name MATCHES "^hwffd_")
      message(FATAL_ERROR "hwffd_sanitize(${library}): it links ${name}, which has no sanitized copy; "
        "list ${name} before it, or the two kinds of memory meet in one program")
    elseif(link AND NOT link MATCHES "TARGET_PROPERTY")
      list(APPEND replaced ${link})
    endif()
  endforeach()
  set(${result} ${replaced} PARENT_SCOPE)
endfunction()
