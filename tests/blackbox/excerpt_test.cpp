#include "pmts/blackbox/excerpt.hpp"

#include "box_support.hpp"

#include <gmock/gmock.h>

namespace pmts::blackbox {
namespace {

using namespace std::chrono_literals;

class ExcerptTest : public testing::Test {
protected:
    /// 6:00:00 at the second 1, and a clock that was set meanwhile.
    static Record session(core::Duration at, core::Duration set_by = {}) {
        const QDateTime first(QDate(2026, 6, 1), QTime(6, 0), Qt::UTC);
        const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(at - 1s + set_by).count();
        return {.kind = Kind::kSession, .at = at,
                .body = bodyOf({{QStringLiteral("utc"), first.addMSecs(ms).toString(Qt::ISODateWithMs)}})};
    }
    static Record said(Kind kind, core::Duration at, const QString& text) {
        return {.kind = kind, .at = at, .body = bodyOf({{QStringLiteral("text"), text}})};
    }
    std::shared_ptr<const Recording> written(const std::vector<Record>& records, const char* name) {
        return *Recording::open(put(folder, fileOf(records), name));
    }
    /// The excerpt read back: kinds and times.
    std::vector<std::pair<Kind, core::Duration>> takenBy(const ExcerptOrder& order) {
        excerpt = excerptOf(recordings, order);
        const auto again = Recording::open(put(folder, excerpt.bytes, "excerpt.pmtsbox"));
        std::vector<std::pair<Kind, core::Duration>> taken;
        for (const Entry& entry : (*again)->entries()) {
            taken.emplace_back(entry.kind, entry.at);
            text += (*again)->body(entry).value(QStringLiteral("text")).toString();
        }
        return taken;
    }

    QTemporaryDir folder;
    std::vector<std::shared_ptr<const Recording>> recordings{
        written({session(1s), said(Kind::kConnection, 2s, QStringLiteral("connected ")),
                 said(Kind::kLog, 3s, QStringLiteral("old ")), said(Kind::kFrame, 500s, QStringLiteral("/home/jo "))}, "1.pmtsbox"),
        written({session(600s), said(Kind::kLog, 700s, QStringLiteral("/home/jo/x ")), said(Kind::kLog, 900s, QStringLiteral("new"))},
                "2.pmtsbox")};
    Excerpt excerpt;
    QString text;
};

TEST_F(ExcerptTest, TheLastMinutesAndHowThingsStoodBeforeThem) {
    const auto taken = takenBy({.last = 450s, .pictures = true, .scrubber = {}});
    EXPECT_THAT(taken, testing::ElementsAre(std::pair(Kind::kSession, 1s), std::pair(Kind::kConnection, 2s),
                                            std::pair(Kind::kFrame, 500s), std::pair(Kind::kLog, 700s), std::pair(Kind::kLog, 900s)));
    EXPECT_EQ(excerpt.records[Kind::kLog], 2);
}

TEST_F(ExcerptTest, TheTimeOfDayOfItsEndsIsKnown) {
    (void)takenBy({.last = 300s, .pictures = true, .scrubber = {}});
    EXPECT_EQ(excerpt.to_utc, QDateTime::fromString(QStringLiteral("2026-06-01T06:14:59.000Z"), Qt::ISODateWithMs));
}

TEST_F(ExcerptTest, WhereTheClockWasSetTheTimeOfDayIsSaidAgain) {
    recordings[1] = written({session(600s, 24h * 30), said(Kind::kLog, 700s, QStringLiteral("new"))}, "2.pmtsbox");
    const auto taken = takenBy({.last = 300s, .pictures = true, .scrubber = {}});
    EXPECT_THAT(taken, testing::ElementsAre(std::pair(Kind::kSession, 1s), std::pair(Kind::kConnection, 2s),
                                            std::pair(Kind::kFrame, 500s), std::pair(Kind::kSession, 600s), std::pair(Kind::kLog, 700s)));
    EXPECT_EQ(excerpt.from_utc.toUTC(), QDateTime(QDate(2026, 6, 1), QTime(6, 6, 39), Qt::UTC));
    EXPECT_EQ(excerpt.to_utc.toUTC(), QDateTime(QDate(2026, 7, 1), QTime(6, 11, 39), Qt::UTC));
}

TEST_F(ExcerptTest, PicturesMayStayOutAndTextsAreScrubbed) {
    Scrubber scrubber;
    scrubber.hide(QStringLiteral("/home/jo"), QStringLiteral("<home>"));
    const auto taken = takenBy({.last = 1000s, .pictures = false, .scrubber = scrubber});
    EXPECT_THAT(taken, testing::Not(testing::Contains(testing::Key(Kind::kFrame))));
    EXPECT_EQ(text, QStringLiteral("connected old <home>/x new"));
}

}  // namespace
}  // namespace pmts::blackbox
