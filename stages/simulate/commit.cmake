# cmake -D SOURCE=<project> -D OUTPUT=<file> -P commit.cmake: writes the source of commit.h at each build, but touches the
# file only if the commit is another one, so that nothing is compiled or linked again without need. Commits that change
# documents or tests alone do not count: the program stays the same file, and with it what tools/run takes for up to date.
set(sources lib stages CMakeLists.txt)
set(commit unknown)
find_program(GIT git)
if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} log -1 --format=%H -- ${sources}
        OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(hash)
        set(commit ${hash})
        execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain -- ${sources}
            OUTPUT_VARIABLE changes ERROR_QUIET)
        if(changes)
            string(APPEND commit -dirty)
        endif()
    endif()
endif()
set(text "#include \"simulate/commit.h\"\n\nstd::string tidewater::source_commit() { return \"${commit}\"; }\n")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${text}" @ONLY)
