#include "canvoy/tools/page/shared_frames.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::tools {

class SharedFrames::Follower : public FrameStream {
 public:
  Follower(std::shared_ptr<SharedFrames> shared, std::unique_ptr<FrameWalk> own)
      : shared_(std::move(shared)) {
    read_alone(std::move(own));
  }

  void read(std::string& elements, std::size_t bytes_max) override {
    if (own_) {
      own_->read(elements, bytes_max);
      if (own_->next() < next_) return;
      lost_ += own_->take_lost();
      own_.reset();
    }
    if (part_ < shared_->first_part_) return read_on_alone();
    while (elements.size() < bytes_max) {
      const Part* const part = shared_->part(part_);
      if (part == nullptr) return;
      if (!elements.empty() && !part->elements.empty()) elements += ',';
      elements += part->elements;
      next_ = part->end;
      lost_ += part->lost;
      ++part_;
    }
  }
  bool is_behind() const override {
    return own_ || part_ < shared_->end_part() || shared_->walk_->is_behind();
  }
  std::uint64_t take_lost() override {
    return std::exchange(lost_, 0) + (own_ ? own_->take_lost() : 0);
  }
  double searched() const override { return own_ ? own_->searched() : shared_->walk_->searched(); }

 private:
  /// Up to the next common frames.
  void read_alone(std::unique_ptr<FrameWalk> own) {
    own_ = std::move(own);
    part_ = shared_->end_part();
    next_ = shared_->walk_->next();
    own_->end_at(next_);
  }
  void read_on_alone() {
    std::unique_ptr<FrameWalk> own = shared_->make_();
    own->begin_at(next_);
    read_alone(std::move(own));
  }

  std::shared_ptr<SharedFrames> shared_;
  std::unique_ptr<FrameWalk> own_;  ///< null: it reads the common ones
  std::uint64_t part_ = 0;          ///< the next one
  std::uint64_t next_ = 0;          ///< number of the frame with which it begins
  std::uint64_t lost_ = 0;
};

SharedFrames::SharedFrames(Make make) : make_(std::move(make)), walk_(make_()) {
  walk_->begin_at(walk_->end());
}

std::unique_ptr<FrameStream> SharedFrames::join(std::unique_ptr<FrameWalk> own) {
  return std::make_unique<Follower>(shared_from_this(), std::move(own));
}

const SharedFrames::Part* SharedFrames::part(std::uint64_t number) {
  if (number < end_part()) return &parts_[number - first_part_];
  Part next;
  walk_->read(next.elements, part_max);
  next.end = walk_->next();
  next.lost = walk_->take_lost();
  if (next.elements.empty() && next.lost == 0) return nullptr;
  kept_ += next.elements.size();
  parts_.push_back(std::move(next));
  while (kept_ > kept_max && parts_.size() > 1) {
    kept_ -= parts_.front().elements.size();
    parts_.pop_front();
    ++first_part_;
  }
  return &parts_.back();
}

}  // namespace canvoy::tools
