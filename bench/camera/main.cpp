// Figures of the camera room: its lenses beside OpenCV's, and what it costs to show a full HD camera live.
// Options: --minutes N of the live view (0.5).
#include "lens_figures.hpp"
#include "mjpeg_live.hpp"

#include <QCommandLineParser>
#include <QCoreApplication>

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    const QCommandLineOption minutes(QStringLiteral("minutes"), QStringLiteral("Length of the live view."),
                                     QStringLiteral("N"), QStringLiteral("0.5"));
    parser.addOption(minutes);
    parser.process(app);
    pmts::bench::lensFigures();
    pmts::bench::mjpegLive(parser.value(minutes).toDouble());
    return 0;
}
