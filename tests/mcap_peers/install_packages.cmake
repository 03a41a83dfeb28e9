# Installs the npm packages of SOURCE into FOLDER and leaves the file STAMP there. Without a network it
# only warns and leaves none: the next build tries again, and until then the tests say that they are
# skipped.
file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json DESTINATION ${FOLDER})
file(REMOVE ${STAMP})
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
                WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE reason)
if(result EQUAL 0)
  file(TOUCH ${STAMP})
else()
  message(WARNING "npm ci failed, so that programs by others do not check ours:\n${reason}")
endif()
