# Every library PMTS stands on; docs/architecture.md says what each is for.
find_package(Qt6 6.4 REQUIRED COMPONENTS Core Network SerialPort Gui Multimedia Test)
if(EXISTS /usr/bin/python3 AND NOT Python_EXECUTABLE)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "A pyenv earlier in PATH must not win")
endif()
find_package(Python 3.11 REQUIRED COMPONENTS Interpreter)
find_package(QCoro6 0.8 REQUIRED COMPONENTS Core)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgproc imgcodecs calib3d videoio)
find_package(Ceres 2.1 REQUIRED)
find_package(GDAL 3.6 CONFIG REQUIRED)
find_package(exiv2 CONFIG REQUIRED)
if(PMTS_BUILD_GUI)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets Svg SvgWidgets PrintSupport)
    find_package(QCustomPlotQt6 REQUIRED)
endif()
if(PMTS_BUILD_TESTS)
    find_package(GTest 1.12 REQUIRED)
    include(GoogleTest)
endif()

# OpenCV's own targets: only the modules a room asks for are linked.
# Third-party headers are system headers: their warnings are not ours.
