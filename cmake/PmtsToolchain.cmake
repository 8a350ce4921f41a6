# Compiler flags, ccache and the fast linker: everything that is about the tool chain and not about PMTS.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror=return-type)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # gcc 12 sees uninitialised members and endless copies in tl::expected and std::string where there are none.
    add_compile_options(-Wno-maybe-uninitialized -Wno-stringop-overflow)
endif()
add_compile_definitions(QT_NO_KEYWORDS QT_NO_FOREACH)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    # A precompiled header is cached by its own text; base_dir lets build folders share results.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}
        CCACHE_NOHASHDIR=1 ${CCACHE_PROGRAM})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options(-fpch-preprocess)
    endif()
endif()

find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM)
    add_link_options(-fuse-ld=mold)
endif()

if(PMTS_SANITIZE)
    add_compile_options(-fsanitize=${PMTS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${PMTS_SANITIZE})
    # Under a sanitizer Eigen would keep its own header before each block, which Debian's Ceres, built without, does
    # not expect when such a block crosses between them. The sanitizer's malloc aligns to 16 bytes as glibc's does.
    add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
