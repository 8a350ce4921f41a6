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

TEST(ScrubberTest, LoginsInAddressesAreHiddenWhereverTheyStand) {
    const Scrubber nobody;
    const auto scrubbed = [&](const char* text) { return nobody.scrubbed(QString::fromUtf8(text)); };
    EXPECT_EQ(scrubbed("“rtsp://anna:secret@192.168.1.4:554/live” gives no picture"),
              QString::fromUtf8("“rtsp://<login>@192.168.1.4:554/live” gives no picture"));
    EXPECT_EQ(scrubbed("http://anna:p@ss/word@cam/video"), QStringLiteral("http://<login>@cam/video"));
    EXPECT_EQ(scrubbed("rtsp://anna@cam rtsp://berta:b@other"), QStringLiteral("rtsp://<login>@cam rtsp://<login>@other"));
    EXPECT_EQ(scrubbed("rtsp://cam:554/user=anna&password=secret&channel=1"),
              QStringLiteral("rtsp://cam:554/user=<login>&password=<login>&channel=1"));
}

TEST(ScrubberTest, OfFoldersNobodyNamedTheLastPartStays) {
    const auto scrubbed = [](const char* text) { return office().scrubbed(QString::fromUtf8(text)); };
    EXPECT_EQ(scrubbed("“/mnt/Anna Beispiel/Süd/plan.csv” cannot be read"), QString::fromUtf8("“<folder>/plan.csv” cannot be read"));
    EXPECT_EQ(scrubbed("/srv/anna/b.csv to /run/media/anna/c.csv"), QStringLiteral("<folder>/b.csv to <folder>/c.csv"));
    EXPECT_EQ(scrubbed("file:///mnt/anna/x.pgm"), QStringLiteral("file://<folder>/x.pgm"));
    EXPECT_EQ(scrubbed("/home/jo/jobs/a.gpkg"), QStringLiteral("<home>/jobs/a.gpkg"));
}

TEST(ScrubberTest, DevicesAddressesAndUnitsAreNoFolders) {
    for (const char* text : {"/dev/serial/by-id/usb-0 answers", "/usr/lib/x", "rtsp://[::1]/live/main", "12 m/s or km/h, HA / VA",
                             "http://cam/a/b", "../x/y"}) {
        EXPECT_EQ(Scrubber().scrubbed(QString::fromLatin1(text)), QString::fromLatin1(text));
    }
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
