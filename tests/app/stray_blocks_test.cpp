#include "app/field_fixture.hpp"
#include "pmts/app/line/timeline.hpp"

#include <gmock/gmock.h>

#include <set>

namespace pmts::app {
namespace {

/// From the wire to the words of the time line.
class StrayBlocksTest : public FieldTest {
protected:
    void SetUp() override {
        QObject::connect(&instrument, &InstrumentDesk::strayCame, &timeline, &Timeline::addUnasked);
        connectInstrument();
        openJob();
    }
    [[nodiscard]] std::set<std::string> wordsDuringAShotWith(const char* fault) {
        EXPECT_TRUE(station.injectFault(QString::fromLatin1(fault)).has_value());
        EXPECT_TRUE(recordPoint());
        pass(20s);
        std::set<std::string> words;
        for (const LineEvent& event : timeline.events()) {
            words.insert(timeline.words().what(event).toStdString());
        }
        return words;
    }

    Timeline timeline{clock};
};

TEST_F(StrayBlocksTest, AHealthyLineShowsNone) { EXPECT_THAT(wordsDuringAShotWith("none"), testing::IsEmpty()); }

TEST_F(StrayBlocksTest, AnAnswerThatCameAfterItsTimeIsShown) {
    EXPECT_THAT(wordsDuringAShotWith("late=3,on=RG"), testing::ElementsAre("an answer that came too late"));
}

TEST_F(StrayBlocksTest, AnAnswerThatCameTwiceIsShown) {
    EXPECT_THAT(wordsDuringAShotWith("twice,on=RG"), testing::ElementsAre("the same answer once more"));
}

TEST_F(StrayBlocksTest, NoiseBetweenTheBlocksIsShown) {
    on_the_way = [](std::string bytes) { return "\x15~\x7f>" + bytes; };
    EXPECT_THAT(wordsDuringAShotWith("none"), testing::Contains(testing::StartsWith("noise")));
}

}  // namespace
}  // namespace pmts::app
