// Why something that is asked for is not done, as far as who asks by HTTP is told by a status; all
// other UsageErrors are of what the words of a request mean (422).
#pragma once

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

/// It is not what the table of routes has (400).
class NotAsDescribed : public UsageError {
 public:
  using UsageError::UsageError;
};

/// It is understood, and not allowed (403).
class NotAllowed : public UsageError {
 public:
  using UsageError::UsageError;
};

/// There is nothing of this name (404).
class NotThere : public UsageError {
 public:
  using UsageError::UsageError;
};

/// It cannot be done to what is looked at, or not now (409).
class NotNow : public UsageError {
 public:
  using UsageError::UsageError;
};

}  // namespace canvoy::tools
