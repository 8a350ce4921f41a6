#pragma once

#include "pmts/blackbox/recording.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace pmts::blackbox {

inline Record numbered(int number, int size = 40) {
    return {.kind = Kind::kLog, .at = std::chrono::milliseconds(number),
            .body = bodyOf({{QStringLiteral("n"), number}, {QStringLiteral("fill"), QString(size, u'x')}})};
}

inline QByteArray fileOf(const std::vector<Record>& records) {
    QByteArray bytes(kFileHead.data(), static_cast<qsizetype>(kFileHead.size()));
    for (const Record& record : records) {
        bytes += encoded(record);
    }
    return bytes;
}

inline QString put(const QTemporaryDir& folder, const QByteArray& bytes, const char* name = "a.pmtsbox") {
    const QString path = folder.filePath(QLatin1String(name));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    return path;
}

/// The numbers of the numbered records, in the order of the file.
inline std::vector<int> numbersIn(const Recording& recording) {
    std::vector<int> numbers;
    for (const Entry& entry : recording.entries()) {
        if (entry.kind == Kind::kLog) {
            numbers.push_back(static_cast<int>(recording.body(entry).value(QStringLiteral("n")).toInteger()));
        }
    }
    return numbers;
}

}  // namespace pmts::blackbox
