#include "pmts/protocol/reply.hpp"

namespace pmts::protocol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(BlockReaderTest, BlockComesWhenItsEndMarkHasCome) {
    BlockReader reader;
    EXPECT_THAT(reader.feed("0\r\n7=10.2345"), IsEmpty());
    EXPECT_TRUE(reader.hasPending());
    EXPECT_THAT(reader.feed("\r\n>"), ElementsAre("0\r\n7=10.2345\r\n"));
    EXPECT_FALSE(reader.hasPending());
}

TEST(BlockReaderTest, SeveralBlocksInOneChunk) {
    BlockReader reader;
    EXPECT_THAT(reader.feed(">20\r\n>301\r\n>0"), ElementsAre("", "20\r\n", "301\r\n"));
    EXPECT_EQ(reader.pending(), "0");
}

TEST(BlockReaderTest, ChangedEndMarkHoldsForTheBlockBeingRead) {
    BlockReader reader;
    EXPECT_THAT(reader.feed("0\r\n7=10.2345\r\n\x04"), IsEmpty());
    reader.setEndMark('\x04');
    EXPECT_THAT(reader.feed("7=5\r\n\x04"), ElementsAre("0\r\n7=10.2345\r\n", "7=5\r\n"));
}

TEST(BlockReaderTest, WithoutEndMarkTheQuietLineEndsTheBlock) {
    BlockReader reader(std::nullopt);
    EXPECT_THAT(reader.feed("0\r\n7=10."), IsEmpty());
    EXPECT_THAT(reader.feed("2345\r\n"), IsEmpty());
    EXPECT_EQ(reader.flush(), "0\r\n7=10.2345\r\n");
    EXPECT_EQ(reader.flush(), std::nullopt);
}

TEST(BlockReaderTest, PromptsAreVisibleBeforeAnyBlockEnd) {
    BlockReader reader;
    EXPECT_THAT(reader.feed("*"), IsEmpty());
    EXPECT_EQ(reader.pending(), "*");
    reader.clear();
    EXPECT_FALSE(reader.hasPending());
    EXPECT_THAT(reader.feed(">"), ElementsAre(""));
}

TEST(BlockReaderTest, EndlessNoiseDoesNotGrowMemory) {
    BlockReader reader;
    const std::string noise(1 << 16, '\xFF');
    for (int i = 0; i < 40; ++i) {
        EXPECT_THAT(reader.feed(noise), IsEmpty());
    }
    EXPECT_LE(reader.pending().size(), std::size_t{1} << 20);
}

}  // namespace
}  // namespace pmts::protocol
