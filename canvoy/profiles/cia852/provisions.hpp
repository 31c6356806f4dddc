// Provisions of CiA 852 beside its objects: numbering (5.3) and bit rates (6.2).
#pragma once

#include "canvoy/profiles/model/provisions.hpp"

namespace canvoy::cia852 {

inline constexpr BitRateProvision bit_rates[] = {
    {125, Category::mandatory, "6.2"},        {250, Category::mandatory, "6.2"},
    {500, Category::mandatory, "6.2"},        {1000, Category::mandatory, "6.2"},
    {10, Category::optional, "6.2, CiA 301"}, {20, Category::optional, "6.2, CiA 301"},
    {50, Category::optional, "6.2, CiA 301"}, {800, Category::optional, "6.2, CiA 301"},
};

inline constexpr RuleProvision rules[] = {
    {"numbering of sub-devices", "odd numbers: of the right hand or foot", "5.3"},
    {"numbering of sub-devices", "even numbers: of the left hand or foot", "5.3"},
    {"numbering of sub-devices",
     "they count from the centre line outward, to the left or to the right, and from the bottom up",
     "5.3"},
    {"numbering of sub-devices", "indicators are numbered in the same way", "5.3"},
    {"numbering of components",
     "push-buttons, indicators and the buttons of joysticks count from left to right and away from "
     "the body, whichever hand or foot they are for",
     "5.3"},
    {"bit rate", "assigned by LSS (CiA 305)", "6.2"},
    {"bit rate", "where there are several, automatic detection by CiA 801 is recommended", "6.2"},
    {"bit rate", "setting it by SDO is not recommended", "6.2"},
};

inline constexpr Provisions provisions = {.bit_rates = bit_rates, .rules = rules};

}  // namespace canvoy::cia852
