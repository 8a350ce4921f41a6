# A room is one static library: headers in include/pmts/<room>, the rest in src/<room>.
# Its ROOMS and LIBRARIES are its permission to include (docs/architecture.md, section 2).
set(PMTS_PCH_LIBRARY <QObject> <QString> <chrono> <functional> <memory> <optional> <string> <vector>
    <qcoro/qcorotask.h> <tl/expected.hpp>)
set(PMTS_PCH_TEST ${PMTS_PCH_LIBRARY} <gmock/gmock.h> <gtest/gtest.h>)

function(pmts_room name)
    cmake_parse_arguments(ARG "" "" "SOURCES;ROOMS;LIBRARIES" ${ARGN})
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/pmts/${name}/*.hpp)   # for moc
    add_library(pmts_${name} STATIC ${ARG_SOURCES} ${headers})
    add_library(pmts::${name} ALIAS pmts_${name})
    target_include_directories(pmts_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include
        PRIVATE ${PROJECT_SOURCE_DIR}/src/${name})
    list(TRANSFORM ARG_ROOMS PREPEND pmts_ OUTPUT_VARIABLE rooms)
    target_link_libraries(pmts_${name} PUBLIC ${rooms} ${ARG_LIBRARIES} Qt6::Core QCoro6::Core)
    target_precompile_headers(pmts_${name} PRIVATE ${PMTS_PCH_LIBRARY})
endfunction()

# Programs that open serial ports one after the other, never side by side: Qt lets go of a port's lock file a moment
# after the port, and the next pty may already have its name.
set(PMTS_SERIAL_PORTS RESOURCE_LOCK serial_ports)
set(PMTS_LSAN LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/lsan.supp)

# Each GTest of a program as a test. ON_SERIAL_PORTS names the test classes that open a port by its device.
function(pmts_discover_tests target)
    cmake_parse_arguments(ARG "" "PREFIX" "PROPERTIES;ON_SERIAL_PORTS" ${ARGN})
    set(how TEST_PREFIX ${ARG_PREFIX}. DISCOVERY_MODE PRE_TEST)
    if(ARG_ON_SERIAL_PORTS)
        list(TRANSFORM ARG_ON_SERIAL_PORTS APPEND .*)
        list(JOIN ARG_ON_SERIAL_PORTS : on_ports)
        gtest_discover_tests(${target} ${how} TEST_FILTER ${on_ports} PROPERTIES ${ARG_PROPERTIES} ${PMTS_SERIAL_PORTS})
        list(APPEND how TEST_FILTER -${on_ports})
    endif()
    gtest_discover_tests(${target} ${how} PROPERTIES ${ARG_PROPERTIES})
endfunction()

# The tests of a room: one program, tests/<room>/*_test.cpp, one GTest per behaviour.
function(pmts_room_tests name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES;ON_SERIAL_PORTS" ${ARGN})
    add_executable(pmts_${name}_tests ${ARG_SOURCES})
    target_link_libraries(pmts_${name}_tests PRIVATE pmts_${name} pmts_test_support ${ARG_LIBRARIES})
    target_include_directories(pmts_${name}_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/src/${name})
    target_compile_definitions(pmts_${name}_tests PRIVATE PMTS_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
    target_precompile_headers(pmts_${name}_tests PRIVATE ${PMTS_PCH_TEST})
    pmts_discover_tests(pmts_${name}_tests PREFIX ${name} ON_SERIAL_PORTS ${ARG_ON_SERIAL_PORTS}
        PROPERTIES TIMEOUT 120 ENVIRONMENT "QT_QPA_PLATFORM=offscreen;${PMTS_LSAN}")
endfunction()

# A benchmark of a room: bench/<room>/<name>.cpp, prints the lines of bench/support/figure.hpp.
function(pmts_bench room)
    cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
    add_executable(bench_${room} ${ARG_SOURCES})
    target_link_libraries(bench_${room} PRIVATE pmts_${room} pmts_bench_support ${ARG_LIBRARIES})
    target_compile_definitions(bench_${room} PRIVATE PMTS_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
endfunction()
