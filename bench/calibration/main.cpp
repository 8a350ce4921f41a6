#include "self_calibration.hpp"

#include <QCoreApplication>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    pmts::bench::thesisPhoto();
    pmts::bench::selfCalibration();
}
