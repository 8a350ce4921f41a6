#include "job_support.hpp"

#include <QFile>

#include <random>

namespace pmts::job {
namespace {

using core::ErrorKind;
using test::FailedWith;

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    ASSERT_EQ(file.write(bytes), bytes.size());
}

class DamagedJobTest : public JobTest {
protected:
    void SetUp() override {
        createWith(200);
        whole = contents(path);
    }
    QByteArray whole;
};

TEST_F(DamagedJobTest, IsRefusedWhenEmptyOrCutAnywhere) {
    for (const qsizetype size : {qsizetype(0), qsizetype(50), qsizetype(100), qsizetype(4096),
                                 whole.size() / 2, whole.size() - 4096}) {
        write(path, whole.left(size));
        const auto outcome = Job::open(path);
        ASSERT_THAT(outcome, FailedWith(ErrorKind::kFile)) << size;
        EXPECT_TRUE(outcome.error().happened.contains(QStringLiteral("damaged"))) << size;
        EXPECT_FALSE(outcome.error().remedy.isEmpty());
        EXPECT_EQ(contents(path), whole.left(size)) << "evidence was changed";
    }
}

TEST_F(DamagedJobTest, IsRefusedWhenAllIsZeroOrGarbage) {
    write(path, QByteArray(whole.size(), '\0'));
    EXPECT_TRUE(Job::open(path).error().happened.contains(QStringLiteral("damaged")));
    QByteArray garbage = whole.left(100);
    std::mt19937 dice(1);
    while (garbage.size() < whole.size()) {
        garbage.append(static_cast<char>(dice()));
    }
    write(path, garbage);
    EXPECT_TRUE(Job::open(path).error().happened.contains(QStringLiteral("damaged")));
}

TEST_F(DamagedJobTest, IsRefusedWhicheverOfItsPagesInUseIsZeroed) {
    const int pages = static_cast<int>(whole.size() / 4096);
    int refused = 0;
    for (int page = 0; page < pages; ++page) {
        QByteArray holed = whole;
        holed.replace(qsizetype(page) * 4096, 4096, QByteArray(4096, '\0'));
        const QString copy = folder.filePath(QStringLiteral("holed.gpkg"));
        write(copy, holed);
        const auto outcome = Job::open(copy);
        if (!outcome) {
            ASSERT_THAT(outcome, FailedWith(ErrorKind::kFile)) << page;
            ++refused;
        } else {
            // What SQLite cannot know to be a hole: nothing of the record may hang on it.
            ASSERT_EQ((*outcome)->points()->size(), 200U) << page;
        }
    }
    EXPECT_GE(refused, pages - 3);
}

TEST_F(DamagedJobTest, NeverTakesTheProgramDown) {
    std::mt19937 dice(20150709);
    for (int round = 0; round < 60; ++round) {
        QByteArray hurt = whole;
        const auto bytes = 1 + dice() % 400;
        const auto from = static_cast<qsizetype>(dice() % static_cast<unsigned>(whole.size()));
        for (unsigned i = 0; i < bytes && from + i < hurt.size(); ++i) {
            hurt[from + i] = static_cast<char>(dice());
        }
        const QString copy = folder.filePath(QStringLiteral("hurt.gpkg"));
        write(copy, hurt);
        const auto outcome = Job::open(copy);
        if (!outcome) {
            EXPECT_THAT(outcome, FailedWith(ErrorKind::kFile)) << round;
        } else {
            (void)(*outcome)->points();
            (void)(*outcome)->record(shotPoint(1));
        }
    }
}

}  // namespace
}  // namespace pmts::job
