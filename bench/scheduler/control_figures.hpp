#pragma once

namespace pmts::bench {

/// A million transactions of PMTS and a panel at random in virtual time: how many were mixed up.
void measureArbitration();
/// What PMTS adds to a panel's command and to its answer, over real ptys, while the main thread is busy.
void measurePassThrough();

}  // namespace pmts::bench
