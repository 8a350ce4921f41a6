#include "../../src/programs/pmts_line/reports.hpp"

#include "protocol/sampled_line.hpp"
#include "support/matchers.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <cpl_vsi.h>
#include <gtest/gtest.h>

namespace pmts::line {
namespace {

using pmts::test::FailedWith;

constexpr std::string_view kBlock = "A,166=96.16838\rA,165=177.56115\x04";

class PmtsLineTest : public testing::Test {
protected:
    [[nodiscard]] QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
    void write(const QString& name, std::string_view bytes) {
        VSILFILE* const file = VSIFOpenL(name.toUtf8().constData(), "wb");
        ASSERT_NE(file, nullptr);
        ASSERT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), file), bytes.size());
        VSIFCloseL(file);
    }
    /// What the program prints for these words.
    static core::Result<QString> run(QStringList words) {
        const auto request = readCommandLine(words << QStringLiteral("--times"));
        PMTS_TRY(request);
        return reportOf(*request);
    }
    static core::Result<QString> decoded(const QString& file) {
        return run({QStringLiteral("pmts-line"), QStringLiteral("decode"), file});
    }

private:
    QTemporaryDir folder_;
};

TEST_F(PmtsLineTest, SessionOfSigrokIsReadInItsChunks) {
    const std::string samples = protocol::test::samplesOf(kBlock, {.samples_per_bit = 20.0});
    const QString archive = QStringLiteral("/vsizip/") + path("bus.zip") + QLatin1Char('/');
    VSILFILE* const zip = VSIFOpenL(archive.chopped(1).toUtf8().constData(), "wb");  // stays open while its files are written
    ASSERT_NE(zip, nullptr);
    write(archive + QStringLiteral("version"), "2");
    write(archive + QStringLiteral("metadata"),
          "[global]\nsigrok version=0.5.1\n\n[device 1]\ncapturefile=logic-1\ntotal probes=8\nsamplerate=192 kHz\n"
          "probe1=DATA\nunitsize=1\n");
    write(archive + QStringLiteral("logic-1-1"), std::string_view(samples).substr(0, 1000));
    write(archive + QStringLiteral("logic-1-2"), std::string_view(samples).substr(1000));
    VSIFCloseL(zip);
    ASSERT_TRUE(QFile::rename(path("bus.zip"), path("bus.sr")));

    const auto report = decoded(path("bus.sr"));
    ASSERT_TRUE(report) << report.error().sentence().toStdString();
    EXPECT_TRUE(report->contains(QStringLiteral("9600 baud"))) << report->toStdString();
    EXPECT_TRUE(report->contains(QStringLiteral("A,166=96.16838<CR>\n"))) << report->toStdString();
    EXPECT_TRUE(report->contains(QStringLiteral("A,165=177.56115<EOT>\n")));
    const auto pins = run({QStringLiteral("pmts-line"), QStringLiteral("pins"), path("bus.sr")});
    EXPECT_TRUE(pins && pins->contains(QStringLiteral("DATA")));
}

TEST_F(PmtsLineTest, AnotherArchiveIsRefusedWithASentence) {
    write(path("photo.zip"), "PK\x03\x04 something else");
    EXPECT_THAT(decoded(path("photo.zip")), FailedWith(core::ErrorKind::kBadInput));
}

TEST_F(PmtsLineTest, MissingFileIsSaid) { EXPECT_THAT(decoded(path("nothing")), FailedWith(core::ErrorKind::kFile)); }

TEST_F(PmtsLineTest, CaptureThatRestsSaysSo) {
    write(path("rest.bin"), std::string(5000, '\x01'));
    EXPECT_THAT(decoded(path("rest.bin")), FailedWith(core::ErrorKind::kUndefined));
}

TEST_F(PmtsLineTest, GivenFormIsTakenAsItIs) {
    const std::string samples = protocol::test::samplesOf("42", {.samples_per_bit = 10.0, .data_bits = 7, .parity = 'E'});
    write(path("short.bin"), samples);
    const auto report = run({QStringLiteral("pmts-line"), QStringLiteral("decode"), path("short.bin"), QStringLiteral("--rate"),
                             QStringLiteral("96000"), QStringLiteral("--baud"), QStringLiteral("9600"), QStringLiteral("--form"),
                             QStringLiteral("7e1")});
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->contains(QStringLiteral("  42\n"))) << report->toStdString();
}

TEST_F(PmtsLineTest, DialogueIsWrittenAsATableAndSearched) {
    write(path("session.log"), "# PMTS session log 1\n@ 2026-06-01T06:00:00.000Z /dev/ttyUSB0 at 9600 8N1\n"
                               "       0.000 > RG,7\\r\n      52.083 < 7=10.2345\\r\\n>\n");
    const auto table = run({QStringLiteral("pmts-line"), QStringLiteral("table"), path("session.log"), QStringLiteral("--name"),
                            QStringLiteral("read_ha")});
    ASSERT_TRUE(table) << table.error().sentence().toStdString();
    EXPECT_TRUE(table->contains(QStringLiteral("routine read_ha\n"))) << table->toStdString();
    EXPECT_TRUE(table->contains(QStringLiteral("send RG,7\n    expect 7=*\n"))) << table->toStdString();
    const auto places = run({QStringLiteral("pmts-line"), QStringLiteral("search"), path("session.log"), QStringLiteral("--text"),
                             QStringLiteral("7=")});
    ASSERT_TRUE(places);
    EXPECT_TRUE(places->contains(QStringLiteral("0.052083 s  7=10.2345<CR>"))) << places->toStdString();
    EXPECT_TRUE(places->contains(QStringLiteral("at 1 places")));
    const auto times = decoded(path("session.log"));
    ASSERT_TRUE(times);
    EXPECT_TRUE(times->contains(QStringLiteral("0.000000 s  → to    RG,7<CR>"))) << times->toStdString();
}

TEST_F(PmtsLineTest, ArgumentsThatMakeNoSenseAreNamed) {
    const QString name = QStringLiteral("pmts-line");
    EXPECT_THAT(readCommandLine({name, QStringLiteral("guess"), QStringLiteral("x")}), FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(readCommandLine({name, QStringLiteral("correlate"), QStringLiteral("x")}),
                FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(readCommandLine({name, QStringLiteral("search"), QStringLiteral("x")}), FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(readCommandLine({name, QStringLiteral("decode"), QStringLiteral("x"), QStringLiteral("--rate=-3")}),
                FailedWith(core::ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::line
