#include "field_fixture.hpp"
#include "pmts/app/line/label_backup_presenter.hpp"
#include "pmts/app/line/memory_presenter.hpp"
#include "pmts/protocol/labels.hpp"

#include <QSignalSpy>
#include <gmock/gmock.h>

#include <algorithm>

namespace pmts::app {
namespace {

using testing::HasSubstr;

/// Two ask for the instrument at a time; only one gives up.
class CancelTest : public FieldTest {
protected:
    void startUpload() {
        connectInstrument();
        memory.openFile(QStringLiteral(PMTS_TEST_DATA "/DEMO1.JOB"));
        memory.upload({protocol::Directory::kJob, QStringLiteral("DEMO1")});
    }
    bool sendsLine(int line) {
        return until([this, line] { return memory.transfer().text.contains(QStringLiteral("Sending: line %1").arg(line)); });
    }

    MemoryPresenter memory{instrument, planned, messages};
    LabelBackupPresenter backup{instrument, messages};
};

TEST_F(CancelTest, WhoCancelsWhatWaitsLeavesTheRunningUploadAlone) {
    startUpload();
    backup.read();
    ASSERT_TRUE(sendsLine(5));
    backup.cancel();
    ASSERT_TRUE(until([this] { return !backup.transfer().busy; }));
    EXPECT_TRUE(memory.transfer().busy);
    ASSERT_TRUE(until([this] { return !memory.transfer().busy; }, 10min));
    EXPECT_TRUE(std::ranges::all_of(memory.document().rows(),
                                    [](const MemoryRow& row) { return row.fate == LineFate::kKept; }))
        << newestBar(messages).toStdString();
}

TEST_F(CancelTest, WhoCancelsTheRunningUploadLeavesWhatWaitsAlone) {
    startUpload();
    ASSERT_TRUE(sendsLine(5));
    QSignalSpy read(&instrument, &InstrumentDesk::labelRead);
    const Ticket ticket = instrument.readLabel(protocol::kTemperature);
    memory.cancel();
    ASSERT_TRUE(until([&] { return read.count() == 1; }));
    EXPECT_EQ(read.front().front().value<Ticket>(), ticket);
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("may hold Job DEMO1"));
}

TEST_F(CancelTest, ATicketThatIsOverCancelsNothing) {
    startUpload();
    const Ticket long_ago = 1;
    ASSERT_TRUE(sendsLine(5));
    instrument.cancel(long_ago);
    instrument.cancel(0);
    ASSERT_TRUE(until([this] { return !memory.transfer().busy; }, 10min));
    EXPECT_EQ(memory.state(), DeviceState::kGood);
}

}  // namespace
}  // namespace pmts::app
