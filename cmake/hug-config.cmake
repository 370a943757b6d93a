# find_package(hug [0.1] [COMPONENTS static shared])
#
#   hug::static   libhug.a, with what it needs of the system
#   hug::shared   libhug.so
#   hug::hug      hug::shared if BUILD_SHARED_LIBS is on or there is no other, else
#                 hug::static
#
# The tree may be moved as a whole. Libraries are looked for in lib, lib64 and
# lib/<architecture> of the prefix, and in hug_LIBRARY_DIR if that is set.
include(CMakeFindDependencyMacro)
find_dependency(Threads)

get_filename_component(_hug_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(_hug_include "${_hug_prefix}/include")
set(_hug_file_static "${CMAKE_STATIC_LIBRARY_PREFIX}hug${CMAKE_STATIC_LIBRARY_SUFFIX}")
set(_hug_file_shared "${CMAKE_SHARED_LIBRARY_PREFIX}hug${CMAKE_SHARED_LIBRARY_SUFFIX}")

foreach(_hug_kind static shared)
  unset(_hug_library CACHE)
  find_library(_hug_library
    NAMES "${_hug_file_${_hug_kind}}"
    PATHS ${hug_LIBRARY_DIR} "${_hug_prefix}"
    PATH_SUFFIXES lib lib64 "lib/${CMAKE_LIBRARY_ARCHITECTURE}"
    NO_DEFAULT_PATH)
  if(_hug_library)
    set(hug_${_hug_kind}_FOUND TRUE)
    if(NOT TARGET hug::${_hug_kind})
      string(TOUPPER "${_hug_kind}" _hug_upper)
      add_library(hug::${_hug_kind} ${_hug_upper} IMPORTED)
      set_target_properties(hug::${_hug_kind} PROPERTIES
        IMPORTED_LOCATION "${_hug_library}"
        INTERFACE_INCLUDE_DIRECTORIES "${_hug_include}")
    endif()
  else()
    set(hug_${_hug_kind}_FOUND FALSE)
  endif()
endforeach()
unset(_hug_library CACHE)

if(TARGET hug::static)
  # What Rust's standard library needs; "m" where there is such a library.
  set(_hug_system Threads::Threads ${CMAKE_DL_LIBS})
  if(UNIX)
    list(APPEND _hug_system m)
  endif()
  set_target_properties(hug::static PROPERTIES INTERFACE_LINK_LIBRARIES "${_hug_system}")
endif()

foreach(_hug_kind IN LISTS hug_FIND_COMPONENTS)
  if(hug_FIND_REQUIRED_${_hug_kind} AND NOT hug_${_hug_kind}_FOUND)
    set(hug_FOUND FALSE)
    set(hug_NOT_FOUND_MESSAGE "no ${_hug_kind} library of hug below ${_hug_prefix}")
  endif()
endforeach()

if(NOT TARGET hug::hug AND (TARGET hug::static OR TARGET hug::shared))
  add_library(hug::hug INTERFACE IMPORTED)
  if(TARGET hug::shared AND (BUILD_SHARED_LIBS OR NOT TARGET hug::static))
    set_target_properties(hug::hug PROPERTIES INTERFACE_LINK_LIBRARIES hug::shared)
  else()
    set_target_properties(hug::hug PROPERTIES INTERFACE_LINK_LIBRARIES hug::static)
  endif()
elseif(NOT TARGET hug::hug)
  set(hug_FOUND FALSE)
  set(hug_NOT_FOUND_MESSAGE "neither ${_hug_file_static} nor ${_hug_file_shared} below ${_hug_prefix}")
endif()
