// Motor files: thrust curves in the RASP format (.eng), as motor makers and certifiers publish them. Part of the
// library physim_scenario.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physim/motor.hpp"
#include "physim/result.hpp"

namespace physim {

/// A motor of a file. Its diameter, length and mass are what a rocket must carry; the rocket's own mass is beside.
struct MotorFileEntry {
  MotorDef motor{};              ///< name, thrust and propellant mass [-]
  double diameter = 0;           ///< [m]
  double length = 0;             ///< [m]
  double mass = 0;               ///< of the loaded motor [kg]
  std::string delays{};          ///< of the ejection charge, as written: "0-3-5-7" [-]
  std::string manufacturer{};    ///< [-]
  std::optional<Error> fault{};  ///< why it cannot be flown, with file:line; nothing where it can [-]
};

/// Reads the motors of a RASP file: lines of comment start with ';'; a motor is a header of seven words (name, diameter
/// in mm, length in mm, delays, propellant in kg, mass in kg, manufacturer) and lines of time in s and thrust in N, up
/// to a thrust of zero. Thrust rises from zero at time 0, which the format leaves out; two points at one time are a
/// step. A motor that cannot be flown is told by its MotorFileEntry::fault and does not stand in the way of the others;
/// an error where no motor can, or where the file begins with something else. Errors carry file:line.
[[nodiscard]] Result<std::vector<MotorFileEntry>> read_motor_file(const std::string& file);
/// Reads motors from the text of a RASP file; `file` only names it in errors.
[[nodiscard]] Result<std::vector<MotorFileEntry>> parse_motor_file(const std::string& text, const std::string& file);
/// The motor of a name, or the only one where the name is empty; an error where it cannot be flown.
[[nodiscard]] Result<MotorFileEntry> pick_motor(const std::vector<MotorFileEntry>& motors, const std::string& name,
                                                const std::string& file);

}  // namespace physim
