// OMPL's exceptions as clearway's.
#pragma once

#include <ompl/util/Exception.h>

#include "clearway/errors.h"

namespace clearway::planning {

/// The OmplError that is thrown.
class OmplRefusal final : public ompl::Exception, public OmplError {
  public:
    using ompl::Exception::Exception;  ///< takes the message
    explicit OmplRefusal(const ompl::Exception& refusal) : ompl::Exception(refusal) {}
    const char* what() const noexcept override { return ompl::Exception::what(); }
};

}  // namespace clearway::planning
