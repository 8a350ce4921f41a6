#include "pmts/job/archive.hpp"

#include "gdal_session.hpp"

#include <cpl_vsi.h>

#include <algorithm>
#include <memory>

namespace pmts::job {

std::optional<QByteArray> archivedFile(const QString& archive, const QString& name, qint64 most_bytes,
                                       const std::function<bool()>& wanted) {
    const GdalTrap quiet;
    const QByteArray path = QStringLiteral("/vsizip/{%1}/%2").arg(archive, name).toUtf8();
    const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> file(VSIFOpenL(path.constData(), "rb"), &VSIFCloseL);
    if (!file) {
        return std::nullopt;
    }
    constexpr qsizetype kBlock = 1 << 20;
    QByteArray bytes;
    for (std::size_t got = 1; got > 0 && bytes.size() < most_bytes && (!wanted || wanted());) {
        const qsizetype size = bytes.size();
        const qsizetype block = std::min<qsizetype>(kBlock, most_bytes - size);
        bytes.resize(size + block);
        got = VSIFReadL(bytes.data() + size, 1, static_cast<std::size_t>(block), file.get());
        bytes.resize(size + static_cast<qsizetype>(got));
    }
    return bytes;
}

}  // namespace pmts::job
