# find_package(carom CONFIG) gives the targets carom::carom (shared) and carom::static.
get_filename_component(_carom "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET carom::carom)
  if(WIN32)
    set(_shared carom.dll)
    set(_static carom.lib)
  elseif(APPLE)
    set(_shared libcarom.dylib)
    set(_static libcarom.a)
  else()
    set(_shared libcarom.so)
    set(_static libcarom.a)
  endif()
  add_library(carom::carom SHARED IMPORTED)
  set_target_properties(carom::carom PROPERTIES
    IMPORTED_LOCATION "${_carom}/lib/${_shared}"
    IMPORTED_IMPLIB "${_carom}/lib/carom.dll.lib"
    IMPORTED_NO_SONAME ON
    INTERFACE_INCLUDE_DIRECTORIES "${_carom}/include")
  add_library(carom::static STATIC IMPORTED)
  set_target_properties(carom::static PROPERTIES
    IMPORTED_LOCATION "${_carom}/lib/${_static}"
    INTERFACE_INCLUDE_DIRECTORIES "${_carom}/include")
  if(UNIX AND NOT APPLE)
    set_target_properties(carom::static PROPERTIES INTERFACE_LINK_LIBRARIES "pthread;dl;m")
  elseif(WIN32)
    set_target_properties(carom::static PROPERTIES INTERFACE_LINK_LIBRARIES "ws2_32;userenv;ntdll;bcrypt")
  endif()
endif()
