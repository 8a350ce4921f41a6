#include "calibration/sightings.hpp"
#include "mounting_figures.hpp"
#include "support/figure.hpp"

#include <QCoreApplication>

#include <cstdio>

using namespace pmts;

/// The rigorous model on the thesis's own photo: 8 parameters, 22 coordinates.
int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);  // the sweep waits on events
    const auto fit =
        calibration::fitRig(test::thesisSightings(), test::thesisStart(), calibration::thesisParameters());
    if (!fit) {
        std::fprintf(stderr, "%s\n", qPrintable(fit.error().sentence()));
        return 1;
    }
    bench::figure("calibration.thesis_rms", fit->rms_px, "px", bench::Wanted::kAtMost, 0.40);
    bench::figure("calibration.thesis_largest", fit->largest_px, "px", bench::Wanted::kAtMost, 0.80);
    return bench::mountingFigures() ? 0 : 1;
}
