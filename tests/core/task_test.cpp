#include "pmts/core/task.hpp"

#include "support/matchers.hpp"
#include "support/run_to_end.hpp"

namespace pmts::core {
namespace {

using namespace std::chrono_literals;
using test::FailedWith;
using test::runToEnd;

Task<Result<int>> addAfterWaiting(Clock& clock, int a, int b, std::stop_token stop) {
    PMTS_CO_TRY(co_await sleepFor(clock, 5s, stop));
    co_return a + b;
}

TEST(TaskTest, SleepTakesItsTimeOnTheClock) {
    VirtualClock clock;
    const auto outcome = runToEnd(addAfterWaiting(clock, 2, 3, {}), clock, 10s);
    ASSERT_TRUE(outcome.has_value());
    EXPECT_EQ(outcome->value(), 5);
    EXPECT_EQ(clock.now(), 5s);
}

TEST(TaskTest, StoppedSleepCompletesAtOnceWithCancelled) {
    VirtualClock clock;
    std::stop_source stop;
    const auto stopper = clock.callAfter(1s, [stop]() mutable { stop.request_stop(); });
    const auto outcome = runToEnd(addAfterWaiting(clock, 2, 3, stop.get_token()), clock, 10s);
    ASSERT_TRUE(outcome.has_value());
    EXPECT_THAT(*outcome, FailedWith(ErrorKind::kCancelled));
    EXPECT_EQ(clock.now(), 1s);
}

Task<Result<int>> await(Completion<int> completion) {
    auto answer = completion.answer();
    completion = Completion<int>();  // give up our own right to answer
    co_return co_await answer;
}

TEST(TaskTest, FirstAnswerOfACompletionWins) {
    VirtualClock clock;
    Completion<int> completion;
    EXPECT_TRUE(completion.complete(1));
    EXPECT_FALSE(completion.complete(2));
    EXPECT_EQ(runToEnd(await(completion), clock, 1s)->value(), 1);
}

TEST(TaskTest, WaiterIsCancelledWhenNobodyCanAnswerAnyMore) {
    VirtualClock clock;
    std::optional<Completion<int>> completion(std::in_place);
    auto task = await(*completion);
    completion.reset();
    const auto outcome = runToEnd(std::move(task), clock, 1s);
    ASSERT_TRUE(outcome.has_value()) << "the waiter was left suspended";
    EXPECT_THAT(*outcome, FailedWith(ErrorKind::kCancelled));
}

TEST(TaskTest, WaiterResumesThroughTheEventLoopNotInsideComplete) {
    VirtualClock clock;
    Completion<int> completion;
    bool resumed = false;
    auto waiting = [](Completion<int> c, bool* flag) -> Task<void> {
        auto answer = c.answer();
        (void)co_await answer;
        *flag = true;
    }(completion, &resumed);
    completion.complete(7);
    EXPECT_FALSE(resumed);
    deliverQueuedEvents();
    EXPECT_TRUE(resumed);
}

}  // namespace
}  // namespace pmts::core
