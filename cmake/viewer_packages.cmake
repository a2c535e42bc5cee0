# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# Installs the viewer's locked npm packages into viewer/node_modules, which all builds share, unless they are
# there: cmake -DNPM= -DFOLDER= -DOMIT= -DPACKAGE= -DSTAMP= -P viewer_packages.cmake, with a package that must be there.
file(LOCK ${FOLDER} DIRECTORY GUARD PROCESS)
set(installed ${FOLDER}/node_modules/.package-lock.json)
if(NOT EXISTS ${FOLDER}/node_modules/${PACKAGE} OR NOT ${installed} IS_NEWER_THAN ${FOLDER}/package-lock.json)
    execute_process(COMMAND ${NPM} ci ${OMIT} --ignore-scripts --no-audit --no-fund --loglevel=error
        WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
    file(TOUCH ${installed})
endif()
file(TOUCH ${STAMP})
