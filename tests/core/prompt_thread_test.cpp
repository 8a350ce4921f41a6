#include "pmts/core/prompt_thread.hpp"

#include <gtest/gtest.h>

#include <pthread.h>
#include <sched.h>
#include <thread>

namespace pmts::core {
namespace {

int policyOfThisThread() {
    int policy = 0;
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    return policy & ~SCHED_RESET_ON_FORK;
}

TEST(PromptThread, SaysTruthfullyWhetherTheSystemAllowedIt) {
    bool allowed = false;
    int policy = 0;
    std::thread([&] {
        allowed = makeThisThreadPrompt();
        policy = policyOfThisThread();
    }).join();

    EXPECT_EQ(policy, allowed ? SCHED_RR : SCHED_OTHER);
    EXPECT_EQ(policyOfThisThread(), SCHED_OTHER);  // the others run as before
}

}  // namespace
}  // namespace pmts::core
