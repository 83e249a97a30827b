// A linked shader program.
#pragma once

#include <epoxy/gl.h>

#include "physim/result.hpp"
#include "simclient/core/palette.hpp"

namespace physim::client {

class Shader {
 public:
  Shader() = default;
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  ~Shader() {
    if (program_ != 0) glDeleteProgram(program_);
  }
  /// `head`: lines before those of the fragment's shader.
  [[nodiscard]] Status make(const char* name, const char* vertex, const char* fragment, const char* head = "");

  void use() const { glUseProgram(program_); }
  [[nodiscard]] GLint uniform(const char* name) const { return glGetUniformLocation(program_, name); }

 private:
  GLuint program_ = 0;
};

/// The bound array takes the bound buffer for rows of LitVertex: locations 0 to 2 are its members.
void read_lit_vertices();

/// A uniform of three numbers: part of a colour's red, green and blue, from 0 to 1.
void hand_colour(const Shader& shader, const char* name, Colour colour, double part = 1);

}  // namespace physim::client
