# Writes OUTPUT from INPUT with the git hash of the moment; leaves it alone if nothing changed.
set(GIT_HASH "unknown")
find_program(git git)
if(git AND EXISTS "${SOURCE_DIR}/.git")
  execute_process(COMMAND ${git} describe --always --dirty --abbrev=12 --exclude=*
    WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE described RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(GIT_HASH "${described}")
  endif()
endif()
configure_file("${INPUT}" "${OUTPUT}" @ONLY)
