#include "pmts/blackbox/scrubber.hpp"

#include <QCborMap>
#include <gtest/gtest.h>

namespace pmts::blackbox {
namespace {

Scrubber office() {
    Scrubber scrubber;
    scrubber.hide(QStringLiteral("/home/jo"), QStringLiteral("<home>"));
    scrubber.hide(QStringLiteral("/home/jo/Baustelle Süd"), QStringLiteral("<job folder>"));
    scrubber.hideWord(QStringLiteral("jo"), QStringLiteral("<user>"));
    scrubber.hideWord(QStringLiteral("tripod-7"), QStringLiteral("<host>"));
    return scrubber;
}

TEST(ScrubberTest, TheLongestPathIsHiddenFirst) {
    EXPECT_EQ(office().scrubbed(QStringLiteral("/home/jo/Baustelle Süd/a.gpkg and /home/jo/b")),
              QStringLiteral("<job folder>/a.gpkg and <home>/b"));
}

TEST(ScrubberTest, AUsersNameIsHiddenAsAWordOnly) {
    EXPECT_EQ(office().scrubbed(QStringLiteral("Jo on TRIPOD-7: job major jo.")),
              QStringLiteral("<user> on <host>: job major <user>."));
}

TEST(ScrubberTest, PathsOfLinksAreHiddenToo) {
    EXPECT_EQ(office().scrubbed(QStringLiteral("file:///home/jo/Baustelle%20S%C3%BCd/x")), QStringLiteral("file://<job folder>/x"));
}

TEST(ScrubberTest, NothingAndTheRootAreNotHidden) {
    Scrubber scrubber;
    scrubber.hide(QString(), QStringLiteral("<home>"));
    scrubber.hide(QStringLiteral("/"), QStringLiteral("<home>"));
    EXPECT_EQ(scrubber.scrubbed(QStringLiteral("/usr/bin")), QStringLiteral("/usr/bin"));
}

TEST(ScrubberTest, NestedValuesAreScrubbedAndBytesOfTheWireStayWhatTheyAre) {
    const QByteArray wire("\xB1\x0B RG,7\r", 8);
    const QCborMap map{{QStringLiteral("path"), QStringLiteral("/home/jo/x")},
                       {QStringLiteral("list"), QCborMap{{QStringLiteral("jo"), QByteArray("/home/jo")}}},
                       {QStringLiteral("wire"), wire}};
    const QCborMap scrubbed = office().scrubbed(QCborValue(map)).toMap();
    EXPECT_EQ(scrubbed.value(QStringLiteral("path")).toString(), QStringLiteral("<home>/x"));
    EXPECT_EQ(scrubbed.value(QStringLiteral("list")).toMap().value(QStringLiteral("<user>")).toByteArray(), "<home>");
    EXPECT_EQ(scrubbed.value(QStringLiteral("wire")).toByteArray(), wire);
}

}  // namespace
}  // namespace pmts::blackbox
