#include "pmts/app/unit_format.hpp"
#include "pmts/app/workbench.hpp"
