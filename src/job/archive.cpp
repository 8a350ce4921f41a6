#include "pmts/job/archive.hpp"

#include "gdal_session.hpp"

#include <cpl_vsi.h>

#include <memory>

namespace pmts::job {

std::optional<QByteArray> archivedFile(const QString& archive, const QString& name, const std::function<bool()>& wanted) {
    const GdalTrap quiet;
    const QByteArray path = QStringLiteral("/vsizip/{%1}/%2").arg(archive, name).toUtf8();
    const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> file(VSIFOpenL(path.constData(), "rb"), &VSIFCloseL);
    if (!file) {
        return std::nullopt;
    }
    constexpr qsizetype kBlock = 1 << 20;
    QByteArray bytes;
    for (std::size_t got = 1; got > 0 && (!wanted || wanted());) {
        const qsizetype size = bytes.size();
        bytes.resize(size + kBlock);
        got = VSIFReadL(bytes.data() + size, 1, kBlock, file.get());
        bytes.resize(size + static_cast<qsizetype>(got));
    }
    return bytes;
}

}  // namespace pmts::job
