# The message wheels export CMake targets that list the Python headers of the image they were built in
# (/opt/python/cp311-cp311/include/...). CMake stops at an include directory that does not exist, so such entries
# are taken out of every imported target of a project, after its last find_package(). The headers of this machine
# reach the compiler through Python3::Python and Python3::NumPy, which rosidl_generator_py links itself.
#
# Use: -DCMAKE_PROJECT_INCLUDE=<this file>, which CMake reads right after project().

if(CMAKE_VERSION VERSION_LESS 3.21)
  message(FATAL_ERROR "ROS 2 from wheels needs CMake 3.21 or newer, this is ${CMAKE_VERSION}: pip install cmake")
endif()

function(drop_missing_includes)
  get_property(imported DIRECTORY PROPERTY IMPORTED_TARGETS)
  foreach(target IN LISTS imported)
    get_target_property(includes ${target} INTERFACE_INCLUDE_DIRECTORIES)
    if(NOT includes MATCHES "/opt/python/")
      continue()
    endif()
    set(present "")
    foreach(include IN LISTS includes)
      if(EXISTS "${include}" OR NOT include MATCHES "^/opt/python/")
        list(APPEND present "${include}")
      endif()
    endforeach()
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${present}")
  endforeach()
endfunction()

cmake_language(DEFER CALL drop_missing_includes)
