#include "figures.hpp"

#include <QCoreApplication>
#include <QLoggingCategory>

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QLoggingCategory::setFilterRules(QStringLiteral("pmts.*=false"));
    pmts::bench::measureWire();
    pmts::bench::measureRecords();
    pmts::bench::measureBlackBox();
}
