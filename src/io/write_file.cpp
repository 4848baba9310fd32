#include "coppice/io/write_file.h"

#include "io/new_file.h"

namespace coppice {

void write_file(const std::filesystem::path& file, std::string_view contents) {
    NewFile output(file);
    output.write(contents);
    output.commit();
}

}  // namespace coppice
