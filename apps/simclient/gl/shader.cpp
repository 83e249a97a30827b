#include "simclient/gl/shader.hpp"

#include <cstddef>
#include <string>

#include "simclient/core/lit_vertex.hpp"

namespace physim::client {

Status Shader::make(const char* name, const char* vertex, const char* fragment, const char* head) {
  constexpr const char* kHint = "OpenGL 3.3 is needed";
  char log[1024] = "";
  GLint good = 0;
  program_ = glCreateProgram();
  for (const auto& [kind, source] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
    const char* const parts[] = {kind == GL_FRAGMENT_SHADER ? head : "", source};
    glShaderSource(shader, 2, parts, nullptr);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glAttachShader(program_, shader);
    glDeleteShader(shader);  // goes with the program
    if (good == 0) return Error{std::string("a shader does not compile: ") + log, name, kHint};
  }
  glLinkProgram(program_);
  glGetProgramiv(program_, GL_LINK_STATUS, &good);
  if (good != 0) return {};
  glGetProgramInfoLog(program_, sizeof log, nullptr, log);
  return Error{std::string("a shader does not link: ") + log, name, kHint};
}

void read_lit_vertices() {
  const char* const start = nullptr;
  const GLsizei stride = sizeof(LitVertex);
  for (GLuint i = 0; i < 3; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, start + offsetof(LitVertex, at));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, start + offsetof(LitVertex, normal));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, start + offsetof(LitVertex, colour));
}

void hand_colour(const Shader& shader, const char* name, Colour colour, double part) {
  const auto channel = [&](int shift) {
    return static_cast<float>(part * static_cast<double>(colour >> shift & 0xFFU) / 255);
  };
  glUniform3f(shader.uniform(name), channel(24), channel(16), channel(8));
}

}  // namespace physim::client
