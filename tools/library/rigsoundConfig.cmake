include(${CMAKE_CURRENT_LIST_DIR}/rigsoundTargets.cmake)
