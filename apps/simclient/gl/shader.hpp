// A linked shader program.
#pragma once

#include <epoxy/gl.h>

#include "physim/result.hpp"

namespace physim::client {

class Shader {
 public:
  Shader() = default;
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  ~Shader() {
    if (program_ != 0) glDeleteProgram(program_);
  }
  [[nodiscard]] Status make(const char* name, const char* vertex, const char* fragment);

  void use() const { glUseProgram(program_); }
  [[nodiscard]] GLint uniform(const char* name) const { return glGetUniformLocation(program_, name); }

 private:
  GLuint program_ = 0;
};

}  // namespace physim::client
