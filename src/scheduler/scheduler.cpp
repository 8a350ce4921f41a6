#include "pmts/scheduler/scheduler.hpp"

#include "line.hpp"

namespace pmts::scheduler {

Scheduler::Scheduler(transport::ByteLink& link, core::Clock& clock, core::VideoGate& gate)
    : impl_(std::make_shared<Impl>(link, clock, gate)) {
    impl_->attach(*this);
}

Scheduler::~Scheduler() { impl_->detach(); }

core::Task<core::Result<protocol::Reply>> Scheduler::execute(MicroInstruction instruction,
                                                             std::stop_token stop) {
    return Impl::run(impl_, std::move(instruction), std::move(stop));
}

Hold Scheduler::hold() { return impl_->makeHold(); }
void Scheduler::failAll(const core::Error& error) { impl_->failAll(error); }
void Scheduler::reset(const core::Error& error) { impl_->reset(error); }
void Scheduler::setEndMark(std::optional<char> end_mark) { impl_->setEndMark(end_mark); }
std::optional<char> Scheduler::endMark() const { return impl_->endMark(); }
void Scheduler::setQuietTime(core::Duration quiet_time) { impl_->setQuietTime(quiet_time); }
void Scheduler::setStreamHead(std::string head) { impl_->setStreamHead(std::move(head)); }
void Scheduler::setByteTime(core::Duration byte_time) { impl_->setByteTime(byte_time); }
void Scheduler::setKeeper(LineKeeper* keeper) { impl_->setKeeper(keeper); }
void Scheduler::bar(std::optional<core::Error> reason) { impl_->bar(std::move(reason)); }
bool Scheduler::isIdle() const { return impl_->isIdle(); }
LineCounts Scheduler::counts() const { return impl_->counts(); }

}  // namespace pmts::scheduler
