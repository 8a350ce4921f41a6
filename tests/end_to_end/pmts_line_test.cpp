#include "../../src/programs/pmts_line/capture_file.hpp"
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
    static core::Result<QString> decoded(const QString& file) {
        const auto capture = readCapture(file, {}, {});
        PMTS_TRY(capture);
        return decodeReport(*capture, {});
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

    const auto capture = readCapture(path("bus.sr"), {}, {});
    ASSERT_TRUE(capture) << capture.error().sentence().toStdString();
    EXPECT_EQ(capture->samples_per_s, 192e3);
    EXPECT_EQ(capture->names.value(0), QStringLiteral("DATA"));
    const auto report = decodeReport(*capture, {});
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->contains(QStringLiteral("9600 baud"))) << report->toStdString();
    EXPECT_TRUE(report->contains(QStringLiteral("A,166=96.16838<CR>A,165=177.56115<EOT>")));
}

TEST_F(PmtsLineTest, AnotherArchiveIsRefusedWithASentence) {
    write(path("photo.zip"), "PK\x03\x04 something else");
    EXPECT_THAT(readCapture(path("photo.zip"), {}, {}), FailedWith(core::ErrorKind::kBadInput));
}

TEST_F(PmtsLineTest, MissingFileIsSaid) { EXPECT_THAT(decoded(path("nothing")), FailedWith(core::ErrorKind::kFile)); }

TEST_F(PmtsLineTest, CaptureThatRestsSaysSo) {
    write(path("rest.bin"), std::string(5000, '\x01'));
    EXPECT_THAT(decoded(path("rest.bin")), FailedWith(core::ErrorKind::kUndefined));
}

TEST_F(PmtsLineTest, GivenFormIsTakenAsItIs) {
    const std::string samples = protocol::test::samplesOf("42", {.samples_per_bit = 10.0, .data_bits = 7, .parity = 'E'});
    write(path("short.bin"), samples);
    const auto request = readCommandLine({QStringLiteral("pmts-line"), QStringLiteral("decode"), path("short.bin"),
                                          QStringLiteral("--rate"), QStringLiteral("96000"), QStringLiteral("--baud"),
                                          QStringLiteral("9600"), QStringLiteral("--form"), QStringLiteral("7e1")});
    ASSERT_TRUE(request);
    const auto capture = readCapture(request->path, {}, request->samples_per_s);
    ASSERT_TRUE(capture);
    EXPECT_TRUE(decodeReport(*capture, *request)->contains(QStringLiteral("\n42\n")));
}

TEST_F(PmtsLineTest, ArgumentsThatMakeNoSenseAreNamed) {
    const QString name = QStringLiteral("pmts-line");
    EXPECT_THAT(readCommandLine({name, QStringLiteral("guess"), QStringLiteral("x")}), FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(readCommandLine({name, QStringLiteral("correlate"), QStringLiteral("x")}),
                FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(readCommandLine({name, QStringLiteral("decode"), QStringLiteral("x"), QStringLiteral("--rate=-3")}),
                FailedWith(core::ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::line
