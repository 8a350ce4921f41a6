#include "fuzz_input.hpp"

#include "pmts/transport/session_log.hpp"

#include <QTemporaryFile>

using namespace pmts::transport;
using pmts::fuzz::demand;

/// Bytes survive the escape; a log of any bytes is read or refused with a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = pmts::fuzz::textOf(data, size);
    demand(bytesFromEscaped(escapedBytes(bytes)) == std::string(bytes), "bytes there and back");
    static QTemporaryFile file;
    demand(file.open() && file.resize(0) && file.seek(0), "a temporary file");
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    const auto sessions = readSessionLog(file.fileName());
    demand(sessions || !sessions.error().sentence().isEmpty(), "a refusal has a sentence");
    return 0;
}
