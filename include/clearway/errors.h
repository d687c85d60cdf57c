// The exceptions for what a caller, a file or OMPL got wrong: three types under one base. Each is also a standard exception.
#pragma once

#include <stdexcept>
#include <string>

#pragma GCC visibility push(default)

namespace clearway {

/// The base of the types below. `catch (const clearway::Error&)` catches whatever clearway throws because an argument, a file or
/// OMPL is at fault. It leaves what has other causes: std::bad_alloc, what the caller's own functions throw, and ShrinkStopped
/// and planning::AuditStopped, by which the caller stops some work. It is no std::exception itself, because what is thrown
/// already is one.
class Error {
  public:
    virtual ~Error();

    /// The message, in one line: it names the thing, its value and what was expected.
    virtual const char* what() const noexcept = 0;
};

/// An argument is not what was expected, or a value that a problem file or a path file gives; then the message begins with the
/// file's name. In C: CLEARWAY_INVALID_ARGUMENT. In Python: clearway.ArgumentError, a ValueError.
class ArgumentError : public std::invalid_argument, public Error {
  public:
    using std::invalid_argument::invalid_argument;  ///< takes the message
    const char* what() const noexcept override;
};

/// A file cannot be read or written, or is not what its format prescribes; the message names it. In C: CLEARWAY_FILE_ERROR. In
/// Python: clearway.FileError, an OSError and a ValueError.
class FileError : public std::runtime_error, public Error {
  public:
    using std::runtime_error::runtime_error;  ///< takes the message
    const char* what() const noexcept override;
};

/// OMPL refuses what clearway asks of it, with OMPL's own message: thrown by the functions of clearway::planning in which OMPL
/// works, as plan(), checkPath(), makeSetup() and solveSideBySide(). What is thrown is also an ompl::Exception, and
/// so a std::runtime_error; this header needs no OMPL. In Python: clearway.OmplError, a RuntimeError.
class OmplError : public Error {
  public:
    ~OmplError() override;
};

}  // namespace clearway

#pragma GCC visibility pop
