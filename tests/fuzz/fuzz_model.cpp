// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Models, as HDF5. HDF5 opens files only: the input stands in one that is in memory, with the
// digest that it would have, or nothing but that would be looked at.

#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "files/digest.hpp"
#include "fuzz.hpp"
#include "taut/io/model_h5.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    const int file = memfd_create("model.h5", 0);
    std::string content(fuzz::text_of(data, size));
    content += digest_line(content);
    fuzz::require(file >= 0 && write(file, content.data(), content.size()) == std::ssize(content));
    const int result = fuzz::refuse_or_read(
        [&] { static_cast<void>(read_model("/proc/self/fd/" + std::to_string(file))); });
    close(file);
    return result;
}
