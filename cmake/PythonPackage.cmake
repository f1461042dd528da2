# Is the Python package built, and where is it installed? It is with PCL_INDOOR_BUILD_PYTHON, and for the tests where all
# that it needs is there.
set(PCL_INDOOR_WITH_PYTHON OFF)
if(PCL_INDOOR_SANITIZE)
  message(STATUS "With sanitizers the Python package is not built: Python itself has none")
  return()
endif()
set(with_numpy OFF)
foreach(python ${Python3_EXECUTABLE} python3 /usr/bin/python3) # of several Pythons one with NumPy
  execute_process(COMMAND ${python} -c "import numpy" RESULT_VARIABLE problem OUTPUT_QUIET ERROR_QUIET)
  if(problem STREQUAL "0")
    find_program(Python3_EXECUTABLE ${python})
    set(with_numpy ON)
    break()
  endif()
endforeach()
find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module)
if(Python3_FOUND)
  find_package(pybind11 2.10 QUIET CONFIG)
endif()
if(Python3_FOUND AND pybind11_FOUND AND (PCL_INDOOR_BUILD_PYTHON OR with_numpy))
  set(PCL_INDOOR_WITH_PYTHON ON)
elseif(PCL_INDOOR_BUILD_PYTHON)
  message(FATAL_ERROR "The Python package needs pybind11 2.10 or newer, and Python 3.9 or newer with its headers: "
    "apt-get install --no-install-recommends pybind11-dev python3-dev python3-numpy, or -DPCL_INDOOR_BUILD_PYTHON=OFF")
else()
  message(STATUS "pybind11, python3-dev or NumPy was not found: the Python package is neither built nor tested")
  return()
endif()

# Where Python looks for packages below a prefix such as /usr/local
execute_process(OUTPUT_VARIABLE place OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND ${Python3_EXECUTABLE} -c
  "import sysconfig; print(sysconfig.get_path('platlib', vars={'base': '', 'platbase': ''}).replace('/local/', '/').strip('/'))")
set(PCL_INDOOR_PYTHON_DIR ${place} CACHE STRING "Where the Python package is installed, below the prefix")
