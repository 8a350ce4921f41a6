#include "scripted_instrument.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

/// An instrument that does not answer some labels at all.
class LabelSurveyTest : public DriverTest {
protected:
    LabelSurveyTest() {
        link.respond = [this](const std::string& command) -> std::optional<std::string> {
            const bool silent = std::ranges::find(silent_labels, command) != silent_labels.end();
            return silent || dead ? std::nullopt : station.answer(command);
        };
    }
    static const protocol::LabelReading* readingOf(const protocol::LabelBackup& backup, int label) {
        const auto found = std::ranges::find(backup.readings, label, &protocol::LabelReading::label);
        return found == backup.readings.end() ? nullptr : &*found;
    }

    std::vector<std::string> silent_labels;
    bool dead = false;
};

TEST_F(LabelSurveyTest, ASilentLabelIsLeftOpenAndAllTheOthersAreRead) {
    connect();
    silent_labels = {"RG,11\r", "RG,57\r"};
    const core::Duration before = clock.now();
    const auto backup = run(driver.backUpLabels({}, {}), 10min);
    ASSERT_TRUE(backup.has_value()) << backup.error().happened.toStdString();
    EXPECT_EQ(backup->readings.size(), protocol::backupLabels().size());
    EXPECT_TRUE(readingOf(*backup, 11)->isSilent());
    EXPECT_TRUE(readingOf(*backup, 57)->isSilent());
    EXPECT_EQ(readingOf(*backup, 30)->data, "5.3");
    EXPECT_TRUE(readingOf(*backup, 12)->refused.has_value());
    EXPECT_LT(clock.now() - before, 90s) << "a silent label is not asked a dozen times";
}

TEST_F(LabelSurveyTest, AnInstrumentThatFallsSilentAltogetherEndsTheSurvey) {
    connect();
    int labels = 0;
    const auto count = [&](const TransferProgress& progress) {
        labels = progress.done;
        dead = progress.done == 20;
    };
    EXPECT_THAT(run(driver.backUpLabels(count, {}), 10min), test::FailedWith(ErrorKind::kTimeOut));
    EXPECT_EQ(labels, 20);
}

}  // namespace
}  // namespace pmts::instrument
