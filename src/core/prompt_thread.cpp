#include "pmts/core/prompt_thread.hpp"

#include <pthread.h>
#include <sched.h>

namespace pmts::core {

bool makeThisThreadPrompt() {
    sched_param lowest{};
    lowest.sched_priority = sched_get_priority_min(SCHED_RR);
    return pthread_setschedparam(pthread_self(), SCHED_RR | SCHED_RESET_ON_FORK, &lowest) == 0;
}

}  // namespace pmts::core
