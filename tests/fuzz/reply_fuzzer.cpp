#include "fuzz_input.hpp"

#include "pmts/protocol/info_code.hpp"
#include "pmts/protocol/reply.hpp"

#include <algorithm>

using namespace pmts::protocol;
using pmts::fuzz::demand;

namespace {

std::vector<std::string> blocksOf(std::string_view bytes, std::size_t chunk, char end_mark) {
    BlockReader reader(end_mark);
    std::vector<std::string> blocks;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(chunk, bytes.size()))) {
        std::ranges::move(reader.feed(bytes.substr(0, chunk)), std::back_inserter(blocks));
    }
    if (auto rest = reader.flush()) {
        blocks.push_back(std::move(*rest));
    }
    demand(!reader.hasPending(), "nothing is left after a flush");
    return blocks;
}

void parseInEveryShape(std::string_view block) {
    for (const auto form : {ReadForm::kStandard, ReadForm::kNames, ReadForm::kDataOnly, ReadForm::kSeparate}) {
        for (const bool one_label : {false, true}) {
            for (const bool file : {false, true}) {
                const Reply reply = parseReply(block, ReplyShape{.form = form, .one_label = one_label, .file = file});
                demand(reply.raw == block, "the raw bytes of a reply are the block");
                for (const Item& item : reply.items) {
                    demand(!item.label || *item.label >= 0, "labels are not negative");
                }
                if (reply.status) {
                    demand(reply.status->code >= 0 && reply.status->code <= 999, "a status has at most three digits");
                    demand(!errorFromStatus(*reply.status).sentence().isEmpty(), "every status has a sentence");
                }
            }
        }
    }
}

}  // namespace

/// The external dialect and the bus's: `>` or EOT (0x04) ends a block. First byte: which, and the size of the chunks.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 1) {
        return 0;
    }
    const char end_mark = data[0] % 2 == 0 ? '>' : '\x04';
    const std::string_view bytes = pmts::fuzz::textOf(data + 1, size - 1);
    const auto blocks = blocksOf(bytes, std::max<std::size_t>(size, 1), end_mark);
    demand(blocks == blocksOf(bytes, 1U + data[0] / 2U, end_mark), "blocks do not depend on the chunks they came in");
    for (const std::string& block : blocks) {
        demand(block.find(end_mark) == std::string::npos, "no end mark inside a block");
        parseInEveryShape(block);
    }
    return 0;
}
