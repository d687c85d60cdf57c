#include "clearway/errors.h"

// Defined here, so that the types' own descriptions are in one library, by which a catch in another one finds them.
namespace clearway {

Error::~Error() = default;

OmplError::~OmplError() = default;

const char* ArgumentError::what() const noexcept {
    return std::invalid_argument::what();
}

const char* FileError::what() const noexcept {
    return std::runtime_error::what();
}

}  // namespace clearway
