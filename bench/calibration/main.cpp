#include "board_figures.hpp"
#include "mounting_figures.hpp"
#include "self_calibration.hpp"

#include <QCoreApplication>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);  // the sweeps wait on events
    pmts::bench::thesisPhoto();
    pmts::bench::selfCalibration();
    pmts::bench::boardFigures();
    return pmts::bench::mountingFigures() ? 0 : 1;
}
