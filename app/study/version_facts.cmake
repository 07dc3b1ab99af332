# Writes version_facts.h; run at every build, but the file changes only when a fact does.
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --exclude=* OUTPUT_VARIABLE GIT_HASH
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT GIT_HASH)
  set(GIT_HASH unknown)
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
