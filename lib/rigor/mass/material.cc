// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/material.h>

#include <array>

namespace rigor::mass {
namespace {

// Where the densities are from. Handbooks differ by a percent; the range says by how much kinds do.
constexpr std::string_view kCrc = "CRC Handbook of Chemistry and Physics";
constexpr std::string_view kAlloys = "alloy data sheets (MatWeb)";
constexpr std::string_view kPolymers = "polymer data sheets (MatWeb)";
constexpr std::string_view kFilaments = "filament data sheets";
constexpr std::string_view kWood = "Wood Handbook (USDA)";
constexpr std::string_view kBuilding = "The Engineering ToolBox";
constexpr std::string_view kMakers = "manufacturers' data sheets";

constexpr std::array kMaterials{
    Material{"aluminum", 2700, 2640, 2830, kAlloys},
    Material{"brass", 8500, 8400, 8730, kAlloys},
    Material{"bronze", 8800, 7400, 8900, kAlloys},
    Material{"cast-iron", 7200, 6800, 7400, kAlloys},
    Material{"copper", 8960, 8900, 8960, kCrc},
    Material{"gold", 19300, 19250, 19320, kCrc},
    Material{"lead", 11340, 11300, 11350, kCrc},
    Material{"magnesium", 1810, 1740, 1840, kAlloys},
    Material{"nickel", 8900, 8880, 8910, kCrc},
    Material{"silver", 10490, 10490, 10500, kCrc},
    Material{"stainless-steel", 8000, 7480, 8030, kAlloys},
    Material{"steel", 7850, 7750, 8050, kAlloys},
    Material{"tin", 7290, 7280, 7310, kCrc},
    Material{"titanium", 4430, 4420, 4510, kAlloys},
    Material{"tungsten", 19300, 19250, 19300, kCrc},
    Material{"zinc", 7140, 7130, 7140, kCrc},

    Material{"abs", 1040, 1020, 1080, kFilaments},
    Material{"asa", 1070, 1050, 1080, kFilaments},
    Material{"hdpe", 950, 930, 970, kPolymers},
    Material{"ldpe", 920, 910, 940, kPolymers},
    Material{"pa12", 1010, 1010, 1020, kFilaments},
    Material{"pa12-sintered", 950, 930, 980, kMakers},
    Material{"pa6", 1130, 1120, 1150, kFilaments},
    Material{"peek", 1300, 1260, 1320, kPolymers},
    Material{"petg", 1270, 1230, 1290, kFilaments},
    Material{"pla", 1240, 1240, 1260, kFilaments},
    Material{"pla-carbon", 1300, 1220, 1300, kFilaments},
    Material{"pla-wood", 1200, 1150, 1250, kFilaments},
    Material{"pmma", 1180, 1170, 1200, kPolymers},
    Material{"polycarbonate", 1200, 1190, 1220, kPolymers},
    Material{"polypropylene", 905, 895, 920, kPolymers},
    Material{"polystyrene", 1050, 1040, 1070, kPolymers},
    Material{"pom", 1410, 1390, 1430, kPolymers},
    Material{"ptfe", 2200, 2130, 2200, kPolymers},
    Material{"pvc", 1380, 1300, 1450, kPolymers},
    Material{"tpu", 1210, 1110, 1250, kFilaments},

    Material{"epdm", 1150, 860, 1400, kPolymers},
    Material{"expanded-polypropylene", 40, 20, 60, kMakers},
    Material{"expanded-polystyrene", 20, 15, 30, kMakers},
    Material{"natural-rubber", 930, 920, 1200, kPolymers},
    Material{"neoprene", 1230, 1230, 1500, kPolymers},
    Material{"polyurethane-foam", 45, 30, 60, kMakers},
    Material{"silicone-rubber", 1150, 1100, 1300, kPolymers},

    Material{"carbon-fibre", 1600, 1500, 1650, kMakers},
    Material{"circuit-board", 1850, 1800, 3000, kMakers},
    Material{"glass-fibre", 1900, 1800, 2000, kMakers},

    Material{"balsa", 160, 100, 250, kWood},
    Material{"mdf", 750, 600, 800, kWood},
    Material{"oak", 720, 600, 900, kWood},
    Material{"pine", 500, 350, 600, kWood},
    Material{"plywood", 600, 500, 700, kWood},

    Material{"brick", 1900, 1500, 2200, kBuilding},
    Material{"cardboard", 690, 100, 700, kBuilding},
    Material{"concrete", 2400, 2200, 2450, kBuilding},
    Material{"glass", 2500, 2400, 2800, kBuilding},
    Material{"granite", 2700, 2600, 2800, kBuilding},
    Material{"ice", 917, 916, 918, kCrc},
    Material{"water", 1000, 958, 1000, kCrc},

    Material{"lithium-ion-cell", 2700, 2400, 2900, kMakers},
    Material{"lithium-polymer-pack", 2000, 1900, 2200, kMakers},
    Material{"neodymium-magnet", 7500, 7400, 7700, kMakers},
};

struct Alias {
  std::string_view word;
  std::string_view name;
};

constexpr std::array kAliases{
    Alias{"acetal", "pom"},
    Alias{"acrylic", "pmma"},
    Alias{"aluminium", "aluminum"},
    Alias{"carbon-fiber", "carbon-fibre"},
    Alias{"delrin", "pom"},
    Alias{"epp", "expanded-polypropylene"},
    Alias{"eps", "expanded-polystyrene"},
    Alias{"fiberglass", "glass-fibre"},
    Alias{"fr4", "circuit-board"},
    Alias{"glass-fiber", "glass-fibre"},
    Alias{"inox", "stainless-steel"},
    Alias{"lipo", "lithium-polymer-pack"},
    Alias{"nylon", "pa12"},
    Alias{"pc", "polycarbonate"},
    Alias{"pcb", "circuit-board"},
    Alias{"perspex", "pmma"},
    Alias{"plexiglass", "pmma"},
    Alias{"pp", "polypropylene"},
    Alias{"rubber", "natural-rubber"},
    Alias{"silicone", "silicone-rubber"},
    Alias{"styrofoam", "expanded-polystyrene"},
    Alias{"teflon", "ptfe"},
};

const Material* exactly(std::string_view name) {
  for (const Material& material : kMaterials) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

}  // namespace

std::span<const Material> materials() { return kMaterials; }

const Material* find_material(std::string_view name) {
  for (const Alias& alias : kAliases) {
    if (alias.word == name) return exactly(alias.name);
  }
  return exactly(name);
}

}  // namespace rigor::mass
