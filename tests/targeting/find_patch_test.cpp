#include "pmts/targeting/find_patch.hpp"

#include "support/matchers.hpp"
#include "targeting/pictures.hpp"

#include <QEventLoop>
#include <QThread>
#include <QTimer>

namespace pmts::targeting {
namespace {

struct Outcome {
    std::optional<core::Result<Match>> match;
    QThread* resumed_on = nullptr;
};

core::Task<void> takeAndFind(FindPatch find, camera::FramePtr frame, std::shared_ptr<Outcome> outcome,
                             std::shared_ptr<QEventLoop> loop) {
    const auto patch = co_await find.take(frame, {300, 200});
    const Expectation same{
        .seen = [](const Eigen::Vector2d& px) { return std::optional<Eigen::Vector2d>(px); }};
    outcome->match = co_await find.find(patch.value(), frame, same);
    outcome->resumed_on = QThread::currentThread();
    loop->quit();
}

TEST(FindPatchTest, PoolAnswersOnTheThreadThatAsked) {
    const auto frame = std::make_shared<camera::Frame>();
    frame->image = test::naturalTexture({640, 480}, 31);
    const auto outcome = std::make_shared<Outcome>();
    const auto loop = std::make_shared<QEventLoop>();
    QTimer::singleShot(std::chrono::seconds(60), loop.get(), &QEventLoop::quit);  // generous; ends at once

    const auto task = takeAndFind(findInPool(PatchMatcher()), frame, outcome, loop);
    EXPECT_FALSE(outcome->match.has_value()) << "the asking thread did the work itself";
    loop->exec();

    ASSERT_TRUE(outcome->match && *outcome->match);
    EXPECT_LE(((*outcome->match)->px - Eigen::Vector2d(300, 200)).norm(), 0.01);
    EXPECT_EQ(outcome->resumed_on, QThread::currentThread());
}

}  // namespace
}  // namespace pmts::targeting
